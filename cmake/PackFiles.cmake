# cmake -Dfunction=... -Dfolder=... "-Dfiles=a.json|b/c.csv" -Doutput=... -P PackFiles.cmake
#
# Writes a source with the text of each file, for the program that is installed without the folder.
string(REPLACE "|" ";" files "${files}")
set(rows)
foreach(file IN LISTS files)
  file(READ "${folder}/${file}" text)
  # A literal holds 64 kB at least; what is longer would have to be cut in pieces.
  string(APPEND rows "    {\"${file}\", R\"packed(${text})packed\"},\n")
endforeach()
file(WRITE "${output}" "#include <array>

#include \"cli/packed_files.hpp\"

namespace coilwright::cli {
namespace {

constexpr auto files = std::to_array<PackedFile>({
${rows}});

}  // namespace

std::span<const PackedFile> ${function}() {
  return files;
}

}  // namespace coilwright::cli
")
