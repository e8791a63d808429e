#include "cli/radfix.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "cli/radlint.h"
#include "fix_models.h"
#include "run.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Outcome radfix(const std::vector<std::string>& args, const Terminal& terminal = {}) {
  return outcome_of(&run_radfix, args, terminal);
}

const std::vector<std::string> kCoarse{"--patch-size", "1", "--element-size", "0.5"};

std::vector<std::string> with(std::vector<std::string> args, const std::vector<std::string>& more) {
  args.insert(args.end(), more.begin(), more.end());
  return args;
}

class Radfix : public InFolder {
 protected:
  [[nodiscard]] std::string write_lit_scene() const {
    write("lit.mtl", kLitMaterials);
    return write("lit.obj", kLitScene);
  }
  [[nodiscard]] std::string write_lamp() const {
    write("lit.mtl", kLitMaterials);
    return write("lamp.obj", kLamp);
  }
  [[nodiscard]] json lint(const std::string& name, const std::string& stage) const {
    return json::parse(outcome_of(&run_radlint, {at(name), "--stage", stage, "--format", "json"}).out);
  }
  [[nodiscard]] json report(const std::string& name = "r.json") const { return json::parse(read(name)); }
};

TEST_F(Radfix, DracoTwinIsJudgedAsThePlainFileIs) {
  const std::string lit = write_lit_scene();
  const Outcome outcome = radfix(with({lit, "-o", at("lit.glb"), "--solve", "--draco"}, kCoarse));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\n  compressed twin " + at("lit.draco.glb")));
  const json plain = lint("lit.glb", "display")["summary"], twin = lint("lit.draco.glb", "display")["summary"];
  EXPECT_EQ(twin, plain);
}

TEST_F(Radfix, DracoTwinNeedsAGlbBesideIt) {
  const std::string box = write("box.obj", kBox);
  for (const char* name : {"out.obj", "out.draco.glb", "out.gltf"}) {
    const Outcome outcome = radfix({box, "-o", at(name), "--draco"});
    EXPECT_EQ(outcome.exit_code, 2) << name;
    EXPECT_THAT(outcome.err, HasSubstr("--draco: writes a twin beside a .glb"));
  }
  EXPECT_EQ(radfix({box, "-o", at("box.glb"), "--draco"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(at("box.draco.glb")));
}

TEST_F(Radfix, CleanModelPassesUnchanged) {
  const std::string box = write("box.obj", kBox);
  const Outcome outcome = radfix({box, "-o", at("out.obj"), "--report", "json=" + at("r.json")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, StartsWith(box + "\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\nnothing to repair\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\npass  read back: 1 warning, 2 notes at stage model\n"));
  const std::string written = read("out.obj");
  EXPECT_THAT(written, StartsWith("# written by radfix"));
  EXPECT_THAT(written, HasSubstr("# radfix T="));
  EXPECT_THAT(written, HasSubstr(kBox.substr(0, kBox.find("f "))));
  EXPECT_THAT(written, HasSubstr("\nf 4 3 2 1\n"));
  EXPECT_EQ(report()["before"]["errors"], 0);
  EXPECT_EQ(report()["after"]["errors"], 0);
  EXPECT_EQ(report()["repair"], "not-needed");
  EXPECT_TRUE(report()["ledger"].empty());
  EXPECT_EQ(report()["tolerance"], report()["inputs"][0]["tolerance"]);
}

TEST_F(Radfix, FlippedFaceIsTurned) {
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  const Outcome outcome = radfix({box, "-o", at("out.obj"), "--report", "json=" + at("r.json")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("faces turned "));
  EXPECT_EQ(report()["before"]["byRule"]["RL110"]["severity"], "error");
  EXPECT_EQ(report()["ledger"], json::parse(R"([{"stage":"orient","operation":"turn-face","rules":["RL110","RL104"],
                                                 "count":1,"largestMovement":0.0,"areaChange":0.0}])"));
  EXPECT_EQ(report()["repair"], "done");
  EXPECT_EQ(lint("out.obj", "model")["verdict"], "pass");
}

TEST_F(Radfix, ContactsAreDrawnIntoFacesAndTheFileIsClean) {
  const std::string lit = write_lit_scene();
  const Outcome outcome = radfix({lit, "-o", at("out.obj"), "--report", "json=" + at("r.json")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(report()["before"]["byRule"].contains("RL211"));
  EXPECT_EQ(lint("out.obj", "model")["summary"]["errors"], 0);
  EXPECT_EQ(lint("out.obj", "model")["tolerance"]["source"], "recorded");
  EXPECT_EQ(lint("out.obj", "model")["tolerance"]["T"], report()["tolerance"]["T"]);
}

TEST_F(Radfix, RepairedTwiceIsRepairedOnce) {
  const std::string lit = write_lit_scene();
  ASSERT_EQ(radfix({lit, "-o", at("once.obj")}).exit_code, 0);
  const Outcome again = radfix({at("once.obj"), "-o", at("twice.obj")});
  EXPECT_THAT(again.out, HasSubstr("nothing to repair"));
  const auto geometry = [](const std::string& text) { return text.substr(text.find("\nv ")); };
  EXPECT_EQ(geometry(read("once.obj")), geometry(read("twice.obj")));
}

TEST_F(Radfix, MeshIsCleanForASolver) {
  const Outcome outcome =
      radfix(with({write_lit_scene(), "-o", at("mesh.ply"), "--mesh", "--report", "json=" + at("r.json")}, kCoarse));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nmeshed\n"));
  const json mesh = report()["mesh"];
  EXPECT_EQ(mesh["patchSize"], 1);
  EXPECT_EQ(mesh["elementSize"], 0.5);
  EXPECT_GT(mesh["patches"], mesh["faces"]);
  EXPECT_GT(mesh["elements"], mesh["patches"]);
  EXPECT_GT(mesh["shape"]["median"], 0.5);
  EXPECT_TRUE(report()["solution"].is_null());
  EXPECT_EQ(lint("mesh.ply", "solve")["summary"]["errors"], 0);
}

TEST_F(Radfix, SolutionIsWrittenWithItsLightAndItsPicture) {
  const Outcome outcome = radfix(with({write_lit_scene(), "-o", at("lit.glb"), "--solve", "--preview", at("lit.PNG"),
                                       "--report", "json=" + at("r.json")},
                                      kCoarse));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nsolved\n"));
  EXPECT_THAT(outcome.out, HasSubstr("picture " + at("lit.PNG")));
  EXPECT_THAT(read("lit.PNG"), StartsWith("\x89PNG\r\n"));
  EXPECT_THAT(read("lit.glb"), HasSubstr("_RADIOSITY"));
  const json solution = report()["solution"];
  EXPECT_EQ(solution["complete"], true);
  EXPECT_LT(solution["unshotShare"], 0.001);
  EXPECT_NEAR(solution["energy"]["emitted"][0].get<double>(), 100, 1e-9);  // 100 W/m² from 1 m²
  EXPECT_NEAR(solution["energy"]["emitted"][2].get<double>(), 80, 1e-9);
  EXPECT_EQ(lint("lit.glb", "display")["summary"]["errors"], 0);
}

TEST_F(Radfix, LengthsInTheFilesUnitMakeThePower) {
  const std::string lit = write_lit_scene();
  ASSERT_EQ(
      radfix(with({lit, "-o", at("a.ply"), "--solve", "--units", "cm", "--report", "json=" + at("r.json")}, kCoarse))
          .exit_code,
      0);
  EXPECT_NEAR(report()["solution"]["energy"]["emitted"][0].get<double>(), 0.01, 1e-9);
}

TEST_F(Radfix, PatchSizesAndExposureAreTaken) {
  const std::string lit = write_lit_scene();
  const auto figures = [&](const std::vector<std::string>& options) {
    EXPECT_EQ(radfix(with({lit, "-o", at("a.glb"), "--solve", "--report", "json=" + at("r.json")}, options)).exit_code,
              0);
    return report();
  };
  const json coarse = figures({"--patch-size", "2", "--exposure", "0.02"});
  const json fine = figures({"--patch-size", "1", "--element-size", "0.25"});
  EXPECT_EQ(coarse["solution"]["exposure"], 0.02);
  EXPECT_EQ(coarse["mesh"]["elementSize"], 0.5);
  EXPECT_LT(coarse["mesh"]["patches"], fine["mesh"]["patches"]);
  const auto before_refinement = [](const json& of) {
    return of["mesh"]["elements"].get<int>() - of["solution"]["elementsAdded"].get<int>();
  };
  EXPECT_LT(before_refinement(coarse), before_refinement(fine));
}

// A face at fault keeps the triangles of its repair: long ones, in which no shadow has a shape.
TEST_F(Radfix, TheLampPostIsMeshedWithoutFaults) {
  const std::string lamp_post = std::string(RAD_SOURCE_DIR) + "/corpus/models/lamp_post.obj";
  ASSERT_EQ(radfix({lamp_post, "-o", at("a.glb"), "--mesh", "--report", "json=" + at("r.json")}).exit_code, 0);
  EXPECT_GT(report()["mesh"]["shape"]["median"].get<double>(), 0.6);
}

TEST_F(Radfix, SkippedRepairLeavesTheErrorsAndSaysSo) {
  const Outcome outcome = radfix({write("box.obj", kBoxWithFlippedFace), "-o", at("out.obj"), "--skip", "repair",
                                  "--report", "json=" + at("r.json")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("\nrepair left out, as asked\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\nFAIL  read back: "));
  EXPECT_THAT(outcome.out, HasSubstr("\nnext: radlint " + at("out.obj")));
  EXPECT_THAT(outcome.err, HasSubstr("errors remain: 1 RL110 normal-inconsistent"));
  EXPECT_THAT(read("out.obj"), HasSubstr("\nf 8 5 1 4\n"));
  EXPECT_EQ(report()["repair"], "skipped");
}

TEST_F(Radfix, ModelWithoutLightIsNotSolved) {
  const Outcome outcome = radfix({write("box.obj", kBox), "-o", at("out.glb"), "--solve"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("no material emits light"));
  EXPECT_THAT(outcome.err, HasSubstr("Ke 100 100 100"));
  EXPECT_FALSE(std::filesystem::exists(at("out.glb")));
}

TEST_F(Radfix, ReflectanceOfOneIsNotSolved) {
  write("lit.mtl", "newmtl white\nKd 1 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 1 1 1\n");
  const Outcome outcome = radfix({write("lit.obj", kLitScene), "-o", at("out.glb"), "--solve"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("material 'white': red reflectance 1"));
  EXPECT_EQ(radfix({at("lit.obj"), "-o", at("out.glb")}).exit_code, 0);
}

TEST_F(Radfix, FacesAreNotLostUnasked) {
  const std::string model = write("bad.obj", kBox + "f 1 2 99\n");
  const Outcome outcome = radfix({model, "-o", at("out.obj"), "--report", "json=" + at("r.json")});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err,
              HasSubstr("faces would be lost (1 RL002 index-out-of-range, first at line 15), so nothing was written"));
  EXPECT_FALSE(std::filesystem::exists(at("out.obj")));
  EXPECT_TRUE(report()["after"].is_null());
  EXPECT_EQ(report()["repair"], "not-done");
}

TEST_F(Radfix, UnreadableAndEmptyInput) {
  const std::string bad = write("bad.ply", "ply\nformat ascii 1.0\nelement");
  const Outcome unreadable = radfix({bad, "-o", at("out.obj"), "--report", "json=" + at("r.json")});
  EXPECT_EQ(unreadable.exit_code, 2);
  EXPECT_THAT(unreadable.err, HasSubstr("bad.ply: cannot be read: "));
  EXPECT_EQ(report()["inputs"][0]["read"], false);
  EXPECT_EQ(radfix({write("empty.obj", "v 0 0 0\n"), "-o", at("out.obj")}).exit_code, 4);
  EXPECT_EQ(radfix({write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "-o", at("out.obj")}).exit_code, 4);
  EXPECT_FALSE(std::filesystem::exists(at("out.obj")));
}

TEST_F(Radfix, PathsAreCheckedBeforeTheWork) {
  const std::string box = write("box.obj", kBox);
  const auto refused = [&](const std::vector<std::string>& args, const std::string& words) {
    const Outcome outcome = radfix(args);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr(words));
  };
  refused({at("none.obj"), "-o", at("out.obj")}, "none.obj: no such file");
  refused({at(""), "-o", at("out.obj")}, "is a folder; name one model file");
  refused({box, "-o", box}, "box.obj: is the input");
  refused({box, "-o", at("./box.obj")}, "is the input");
  refused({box, "-o", at("out.dwg")},
          "one of obj, ply, stl, off, draco.glb, glb, gltf, drc, rad, dxf, city.json, cityjson, 3mf, stage.json");
  refused({box, "-o", at("none/out.obj")}, "there is no folder " + at("none"));
  refused({box, "-o", at("a.obj"), "--preview", at("none/a.png")}, "none/a.png: there is no folder");
  refused({box, "-o", at("a.obj"), "--preview", at("a.jpg")}, "pictures are PNG");
  refused({box, "-o", at("a.obj"), "--preview", at("a.obj")}, "pictures are PNG");
  refused({box, "-o", at("a.obj"), "--report", "json=" + at("a.obj")}, "a.obj: is the output as well");
  refused({box, "-o", at("a.obj"), "--preview", at("a.png"), "--report", "json=" + at("./a.png")},
          "is the preview as well");
  refused({box, "-o", at("a.obj"), "--report", "json=" + box}, "is the input");
  std::filesystem::create_symlink("box.obj", at("link.obj"));
  refused({box, "-o", at("link.obj")}, "is the input");
  refused({box, "-o", at("out.obj"), "--tolerance", "1e-12"}, "box.obj: ");
  EXPECT_EQ(read("box.obj"), kBox);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(at("")), std::filesystem::directory_iterator()), 2);
}

TEST_F(Radfix, WritesEveryFormatAndJudgesItOnTheSameLattice) {
  const std::string lit = write_lit_scene();
  for (const std::string name : {"out.obj", "out.ply", "out.off", "out.glb", "out.gltf"}) {
    const Outcome outcome = radfix({lit, "-o", at(name), "--report", "json=" + at("r.json")});
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err;
    const json again = lint(name, "model");
    EXPECT_EQ(again["tolerance"]["source"], "recorded") << name;
    EXPECT_EQ(again["tolerance"]["T"], report()["inputs"][0]["tolerance"]["T"]) << name;
    EXPECT_EQ(again["inputs"][0]["lattice"], report()["inputs"][0]["lattice"]) << name;
  }
  EXPECT_EQ(radfix({lit, "-o", at("out.STL")}).exit_code, 0);
}

TEST_F(Radfix, SolutionIsWrittenInEveryFormat) {
  const std::string lit = write_lit_scene();
  for (const std::string name : {"out.obj", "out.ply", "out.off", "out.stl", "out.glb", "out.gltf"}) {
    const Outcome outcome = radfix(with({lit, "-o", at(name), "--solve"}, kCoarse));
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err;
    EXPECT_EQ(lint(name, "display")["summary"]["errors"], 0) << name;
  }
}

TEST_F(Radfix, SameBytesForAnyNumberOfThreads) {
  const std::string lit = write_lit_scene();
  for (const std::string jobs : {"1", "2"}) {
    ASSERT_EQ(radfix(with({lit, "-o", at("out.glb"), "--solve", "--preview", at("out.png"), "--report",
                           "json=" + at("r.json"), "--jobs", jobs},
                          kCoarse))
                  .exit_code,
              0);
    for (const std::string name : {"out.glb", "out.png", "r.json"}) {
      std::filesystem::rename(at(name), at(name + jobs));
    }
  }
  EXPECT_EQ(read("out.glb1"), read("out.glb2"));
  EXPECT_EQ(read("out.png1"), read("out.png2"));
  EXPECT_EQ(read("r.json1"), read("r.json2"));
}

TEST_F(Radfix, TimingsOnlyWhenAsked) {
  const std::string lit = write_lit_scene();
  ASSERT_EQ(radfix(with({lit, "-o", at("a.glb"), "--solve", "--report", "json=" + at("r.json")}, kCoarse)).exit_code,
            0);
  EXPECT_TRUE(report()["timings"].empty());
  ASSERT_EQ(radfix(with({lit, "-o", at("a.glb"), "--solve", "--timings", "--report", "json=" + at("r.json")}, kCoarse))
                .exit_code,
            0);
  for (const char* stage : {"grouper", "isect", "coplanar", "pmesh", "emesh", "solve", "bake"}) {
    EXPECT_TRUE(report()["timings"].contains(stage)) << stage;
  }
}

TEST_F(Radfix, ReportsFitTheWidthOfTheTerminal) {
  Terminal terminal;
  terminal.columns = 60;
  const Outcome outcome = radfix(with({write_lit_scene(), "-o", at("a.glb"), "--solve"}, kCoarse), terminal);
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(at("")) != std::string::npos) continue;
    EXPECT_LE(line.size(), 60U) << line;
  }
  EXPECT_THAT(outcome.out, Not(HasSubstr("\x1b")));
}

TEST_F(Radfix, LiveLineOnTerminalsOnlyAndWiped) {
  const std::string box = write("box.obj", kBox);
  EXPECT_EQ(radfix({box, "-o", at("a.obj")}).err, "");
  Terminal terminal;
  terminal.err_is_terminal = true;
  const std::string err = radfix({box, "-o", at("a.obj")}, terminal).err;
  EXPECT_THAT(err, StartsWith("\r\x1b[Kreading"));
  EXPECT_THAT(err, testing::EndsWith("\r\x1b[K"));
}

// Standard error on which the first word, of the reading, is answered with Ctrl-C.
class InterruptingBuffer : public std::stringbuf {
 protected:
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    if (!raised_) std::raise(SIGINT);
    raised_ = true;
    return std::stringbuf::xsputn(text, count);
  }

 private:
  bool raised_ = false;
};

Outcome interrupted_radfix(const std::vector<std::string>& args) {
  std::ostringstream out;
  InterruptingBuffer buffer;
  std::ostream err(&buffer);
  Terminal terminal;
  terminal.err_is_terminal = true;
  const int exit_code = run_radfix(args, out, err, terminal);
  return {exit_code, out.str(), buffer.str()};
}

TEST_F(Radfix, InterruptedRepairIsWrittenAndMarked) {
  const Outcome outcome =
      interrupted_radfix({write_lit_scene(), "-o", at("out.obj"), "--report", "json=" + at("r.json")});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("written, but incomplete"));
  EXPECT_THAT(outcome.out, HasSubstr("stopped before the end"));
  EXPECT_THAT(read("out.obj"), HasSubstr("# radfix incomplete"));
  EXPECT_EQ(report()["incomplete"], true);
}

TEST_F(Radfix, InterruptedSolutionIsWrittenAndMarked) {
  const Outcome outcome = interrupted_radfix(
      with({write_lamp(), "-o", at("out.glb"), "--solve", "--report", "json=" + at("r.json")}, kCoarse));
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nsolved in part\n"));
  EXPECT_THAT(read("out.glb"), HasSubstr("\"incomplete\":true"));
  EXPECT_EQ(report()["solution"]["complete"], false);
}

TEST_F(Radfix, InterruptedBeforeTheMeshWritesNothing) {
  const Outcome outcome = interrupted_radfix(with({write_lit_scene(), "-o", at("out.glb"), "--solve"}, kCoarse));
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted; nothing was written"));
  EXPECT_FALSE(std::filesystem::exists(at("out.glb")));
}

}  // namespace
}  // namespace rad::cli
