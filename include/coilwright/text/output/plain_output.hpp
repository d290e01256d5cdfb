#pragma once

#include <array>
#include <cstddef>
#include <ostream>
#include <streambuf>
#include <string_view>

namespace coilwright::text {

/// What a program prints holds names and reasons from files of others, and a terminal obeys some of their characters.
/// As long as this object lives, a stream shows them as escapes (`\x1b`), as one_line() does, but for line ends and
/// tabs; one that leads to no terminal only those below a blank, so that JSON stays JSON. It takes no memory, so that
/// it works where there is none.
class PlainOutput : public std::streambuf {
 public:
  /// `to_terminal`: whether `stream`, which must outlive this object, leads to one.
  PlainOutput(std::ostream& stream, bool to_terminal);
  ~PlainOutput() override;
  PlainOutput(const PlainOutput&) = delete;
  PlainOutput& operator=(const PlainOutput&) = delete;

  /// Where a stream leads past this: for a file on standard output, and for who moves in a line of the terminal.
  [[nodiscard]] static std::streambuf* past(const std::ostream& stream);

 private:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;
  [[nodiscard]] bool put(std::string_view text);
  [[nodiscard]] bool put_shown(std::string_view text);

  std::ostream& stream_;
  std::streambuf* target_;
  bool to_terminal_;
  std::array<char, 4> begun_{};  // of a letter whose other bytes are to come
  std::size_t begun_size_{};
};

}  // namespace coilwright::text
