// The files that assimp may open: the model's bytes, and companions below its folder.
#pragma once

#include <assimp/IOSystem.hpp>
#include <string>

#include "readers/reader.h"

namespace rad::readers::assimp {

class ModelFiles : public Assimp::IOSystem {
 public:
  /// `name` stands for the model's own bytes.
  ModelFiles(const Input& input, std::string name) : input_(input), name_(std::move(name)) {}

  bool Exists(const char* path) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* path, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  const Input& input_;
  std::string name_;
};

}  // namespace rad::readers::assimp
