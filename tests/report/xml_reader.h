// XML taken apart by expat, for tests.
#pragma once

#include <expat.h>

#include <map>
#include <string>
#include <vector>

namespace rad::report {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;
  std::vector<XmlElement> children;
};

struct XmlDocument {
  XmlElement root;
  std::string fault;  ///< empty where the text is well-formed
};

inline XmlDocument read_xml(const std::string& text) {
  struct Builder {
    XmlElement top;
    std::vector<XmlElement*> open{&top};
  } builder;
  const XML_Parser parser = XML_ParserCreate("UTF-8");
  XML_SetUserData(parser, &builder);
  XML_SetElementHandler(
      parser,
      [](void* data, const char* name, const char** attributes) {
        auto& open = static_cast<Builder*>(data)->open;
        XmlElement& element = open.back()->children.emplace_back();
        element.name = name;
        for (; *attributes != nullptr; attributes += 2) element.attributes[attributes[0]] = attributes[1];
        open.push_back(&element);
      },
      [](void* data, const char*) { static_cast<Builder*>(data)->open.pop_back(); });
  XML_SetCharacterDataHandler(parser, [](void* data, const char* piece, int size) {
    static_cast<Builder*>(data)->open.back()->text.append(piece, static_cast<std::size_t>(size));
  });
  XmlDocument document;
  if (XML_Parse(parser, text.data(), static_cast<int>(text.size()), 1) == XML_STATUS_ERROR) {
    document.fault = XML_ErrorString(XML_GetErrorCode(parser));
  } else {
    document.root = builder.top.children.front();
  }
  XML_ParserFree(parser);
  return document;
}

}  // namespace rad::report
