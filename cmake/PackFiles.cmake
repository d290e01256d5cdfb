# cmake -Droom=... -Dplace=... -Dfunction=... -Dfolder=... "-Dfiles=a.json|b/c.csv" -Doutput=... -P PackFiles.cmake
#
# Writes a source with the text of each file, for the program that is installed without the folder.
string(REPLACE "|" ";" files "${files}")
set(rows)
foreach(file IN LISTS files)
  file(READ "${folder}/${file}" text)
  # The standard asks for 64 kB of a literal at least; GCC and clang take far more.
  string(APPEND rows "    {\"${file}\", R\"packed(${text})packed\"sv},\n")
endforeach()
list(LENGTH files count)
file(WRITE "${output}" "#include <array>

#include \"${place}/packed_files.hpp\"

namespace coilwright::${room} {
namespace {

// A literal that knows its length: nobody counts the letters of half a megabyte at compile time.
using namespace std::string_view_literals;

constexpr std::array<text::PackedFile, ${count}> files = {{
${rows}}};

}  // namespace

std::span<const text::PackedFile> ${function}() {
  return files;
}

}  // namespace coilwright::${room}
")
