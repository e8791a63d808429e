#include "batch/tool_identity.h"

#include <elf.h>
#include <link.h>

#include <cstddef>
#include <cstring>
#include <string_view>

#include "batch/digest.h"
#include "readers/file_bytes.h"
#include "readers/late_parts.h"

namespace rad::batch {

namespace {

constexpr std::size_t aligned(std::size_t size) { return (size + 3) & ~std::size_t{3}; }

// A note: name size, description size, type, then both, each filled up to four bytes.
void add_build_ids(std::string_view notes, std::string& ids) {
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) head;
    std::memcpy(&head, notes.data(), sizeof head);
    const std::size_t name = sizeof head, description = name + aligned(head.n_namesz);
    const std::size_t end = description + aligned(head.n_descsz);
    if (end > notes.size()) return;
    const bool is_gnu = notes.substr(name, head.n_namesz) == std::string_view("GNU", 4);
    if (is_gnu && head.n_type == NT_GNU_BUILD_ID) ids += notes.substr(description, head.n_descsz);
    notes.remove_prefix(end);
  }
}

int add_object(dl_phdr_info* info, std::size_t, void* data) {
  auto& ids = *static_cast<std::string*>(data);
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = info->dlpi_phdr[i];
    if (header.p_type != PT_NOTE) continue;
    // The loader states addresses as numbers.
    const auto* notes = reinterpret_cast<const char*>(info->dlpi_addr + header.p_vaddr);
    add_build_ids({notes, header.p_memsz}, ids);
  }
  return 0;
}

void add_content(const std::filesystem::path& path, std::string& ids) {
  readers::FileBytes file;
  if (file.open(path, UINT64_MAX, readers::FileKind::Regular).empty()) ids += digest_of(file.bytes());
}

int add_program(dl_phdr_info* info, std::size_t size, void* data) {
  add_object(info, size, data);
  return 1;  // the first object is the program itself
}

}  // namespace

std::string tool_identity() {
  std::string ids;
  dl_iterate_phdr(add_program, &ids);
  if (ids.empty()) add_content("/proc/self/exe", ids);
  dl_iterate_phdr(add_object, &ids);
  for (const std::filesystem::path& part : readers::late_parts()) add_content(part, ids);
  return digest_of(ids);
}

}  // namespace rad::batch
