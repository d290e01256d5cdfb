#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/archive/contents.hpp"
#include "coilwright/archive/row.hpp"

namespace coilwright::archive {

/// Selection and order of designs of an archive.
struct Query {
  /// A condition in SQL over the columns of the table of designs: "mass_g < 70 and status = 'ok'". A design that lacks
  /// a value of the condition does not fulfil it. Empty: all designs.
  std::string where{};
  std::string order_by{};             ///< a column for which a design must have a value; empty: the order of recording
  bool descending{false};             ///< whether the largest value comes first
  std::size_t skip{0};                ///< number of designs that are skipped at the start
  std::optional<std::size_t> most{};  ///< largest number of designs
};

/// Reads an archive, also while a run writes to it. Safe to use from several threads.
class Reader {
 public:
  /// Opens an archive and checks every checksum, which takes some seconds for a million designs. Throws InputError for
  /// a file that is no archive, is of a later version, has more in it than an archive (a view, a trigger), cannot be
  /// read, lacks a row, or has a row that was changed.
  explicit Reader(const std::filesystem::path& path);
  ~Reader();
  Reader(Reader&&) noexcept;
  Reader& operator=(Reader&&) noexcept;

  [[nodiscard]] const std::filesystem::path& path() const noexcept;  ///< the path as it was given
  [[nodiscard]] const Contents& contents() const noexcept;           ///< the subject of the archive

  /// Whether the rows have checksums. An archive without them can be read, but no run is answered from it, because
  /// changes on the disk cannot be detected.
  [[nodiscard]] bool has_checksums() const noexcept;

  /// The runs that wrote to it, in their order.
  [[nodiscard]] std::vector<Run> runs() const;

  /// Number of designs recorded for the study itself. Only find() sees those under another modelling choice.
  [[nodiscard]] std::size_t size() const;

  /// Number of designs that fulfil a condition in SQL. Throws std::invalid_argument as each().
  [[nodiscard]] std::size_t count(const std::string& where) const;

  /// Returns `count` of the designs that fulfil a condition in SQL, spread from the first to the last in the order of
  /// recording; all if there are fewer. Throws std::invalid_argument as each().
  [[nodiscard]] std::vector<Row> sample(std::size_t count, const std::string& where) const;

  /// The design of that id; absent if there is none.
  [[nodiscard]] std::optional<Row> row(std::int64_t id) const;

  /// The design with these values of the archive's variables, in the order of its columns, for the study itself or
  /// under another modelling choice. The first call reads all designs; designs that are recorded later are not found.
  [[nodiscard]] std::optional<Row> find(std::span<const Value> variables, std::string_view choice = {}) const;

  /// Calls `take` with each design of a query. Throws std::invalid_argument with SQLite's message for an invalid
  /// condition or an order that is no column, and for a condition that takes more than about a second and 0.1 ms per
  /// design.
  void each(const Query& query, const std::function<void(const Row&)>& take) const;

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace coilwright::archive
