#pragma once

#include <array>
#include <cstddef>
#include <ostream>
#include <streambuf>
#include <string_view>

namespace coilwright::text {

/// A filter of a stream for names and reasons that come from other people's files, because a terminal obeys some of
/// their characters. As long as this object lives, the stream shows them as escapes (`\x1b`), as one_line() does,
/// except line ends and tabs; a stream that leads to no terminal shows only those below a blank as escapes, so that
/// JSON stays JSON. It allocates no memory, so it works when there is none.
class PlainOutput : public std::streambuf {
 public:
  /// Filters `stream`, which must outlive this object; `to_terminal` tells whether it leads to a terminal.
  PlainOutput(std::ostream& stream, bool to_terminal);
  ~PlainOutput() override;
  PlainOutput(const PlainOutput&) = delete;
  PlainOutput& operator=(const PlainOutput&) = delete;

  /// The buffer of a stream behind this filter, for a file on standard output, and for code that moves within a line of
  /// the terminal.
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
