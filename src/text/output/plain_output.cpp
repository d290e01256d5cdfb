#include "coilwright/text/output/plain_output.hpp"

#include <algorithm>
#include <string>

#include "text/code_point.hpp"

namespace coilwright::text {

PlainOutput::PlainOutput(std::ostream& stream, bool to_terminal)
    : stream_(stream), target_(stream.rdbuf(this)), to_terminal_(to_terminal) {}

PlainOutput::~PlainOutput() {
  sync();
  const std::ios::iostate state = stream_.rdstate();
  stream_.rdbuf(target_);
  stream_.clear(state);  // which rdbuf() forgets
}

std::streambuf* PlainOutput::past(const std::ostream& stream) {
  const auto* plain = dynamic_cast<const PlainOutput*>(stream.rdbuf());
  return plain == nullptr ? stream.rdbuf() : plain->target_;
}

PlainOutput::int_type PlainOutput::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  const char letter = traits_type::to_char_type(c);
  return put({&letter, 1}) ? c : traits_type::eof();
}

std::streamsize PlainOutput::xsputn(const char* text, std::streamsize size) {
  return put({text, static_cast<std::size_t>(size)}) ? size : 0;
}

int PlainOutput::sync() {
  const std::string_view begun(begun_.data(), begun_size_);
  begun_size_ = 0;
  return put_shown(begun) && target_->pubsync() == 0 ? 0 : -1;
}

bool PlainOutput::put(std::string_view text) {
  while (begun_size_ > 0 && !text.empty()) {
    begun_[begun_size_++] = text.front();
    text.remove_prefix(1);
    const std::string_view begun(begun_.data(), begun_size_);
    if (is_begun(begun)) continue;
    begun_size_ = 0;
    if (!put_shown(begun)) return false;
  }
  // At most three bytes of a letter are not the whole of it.
  std::size_t rest = std::min<std::size_t>(to_terminal_ ? 3 : 0, text.size());
  while (rest > 0 && !is_begun(text.substr(text.size() - rest))) --rest;
  if (rest > 0) begun_size_ = text.copy(begun_.data(), rest, text.size() - rest);
  return put_shown(text.substr(0, text.size() - rest));
}

bool PlainOutput::put_shown(std::string_view text) {
  const auto put_all = [this](std::string_view bytes) {
    const auto size = static_cast<std::streamsize>(bytes.size());
    return target_->sputn(bytes.data(), size) == size;
  };
  std::size_t plain = 0;  // bytes that are shown as they are, since the last that were not
  while (plain < text.size()) {
    const std::string_view rest = text.substr(plain);
    const auto first = static_cast<unsigned char>(rest.front());
    if (rest.front() == '\n' || rest.front() == '\t' || (first >= 0x20 && first < 0x7F) ||
        (!to_terminal_ && (first >= 0x20 || rest.front() == '\r'))) {
      ++plain;
      continue;
    }
    const std::size_t bytes = std::max<std::size_t>(1, decode(rest).bytes);
    const std::string shown = shown_letter(rest.substr(0, bytes));  // short enough to take no memory
    if (shown == rest.substr(0, bytes)) {
      plain += bytes;
      continue;
    }
    if (!put_all(text.substr(0, plain)) || !put_all(shown)) return false;
    text.remove_prefix(plain + bytes);
    plain = 0;
  }
  return put_all(text);
}

}  // namespace coilwright::text
