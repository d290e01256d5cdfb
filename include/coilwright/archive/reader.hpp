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

/// Which designs of an archive, and in which order.
struct Query {
  /// A condition in SQL over the columns of the table of designs: "mass_g < 70 and status = 'ok'". A design without a
  /// value that it asks for does not hold it. Empty: all designs.
  std::string where{};
  std::string order_by{};             ///< a column, of which a design needs a value; empty: the order of recording
  bool descending{false};             ///< the largest first
  std::size_t skip{0};                ///< without so many of the first
  std::optional<std::size_t> most{};  ///< so many designs at most
};

/// Reads an archive, also while a run writes to it. Safe to use from several threads.
class Reader {
 public:
  /// Throws InputError for a file that is no archive or of a later version, has more in it than an archive (a view, a
  /// trigger), cannot be read, lacks a row, or has one that is not what was written: every checksum is looked at, which
  /// takes some seconds for a million designs.
  explicit Reader(const std::filesystem::path& path);
  ~Reader();
  Reader(Reader&&) noexcept;
  Reader& operator=(Reader&&) noexcept;

  [[nodiscard]] const std::filesystem::path& path() const noexcept;  ///< as it was given
  [[nodiscard]] const Contents& contents() const noexcept;           ///< what it is an archive of

  /// Whether its rows have checksums. An archive of before there were any is read, and nothing tells whether a number
  /// of it has changed on the disk: no run is answered from it.
  [[nodiscard]] bool has_checksums() const noexcept;

  /// The runs that wrote to it, in their order.
  [[nodiscard]] std::vector<Run> runs() const;

  /// Number of designs recorded, as the study has them: what is under another modelling choice is for find() alone.
  [[nodiscard]] std::size_t size() const;

  /// Number of designs that hold a condition in SQL. Throws std::invalid_argument as each().
  [[nodiscard]] std::size_t count(const std::string& where) const;

  /// `count` of the designs that hold a condition in SQL, from the first to the last in the order of recording; all
  /// where there are fewer. Throws std::invalid_argument as each().
  [[nodiscard]] std::vector<Row> sample(std::size_t count, const std::string& where) const;

  /// The design of that id, if there is one.
  [[nodiscard]] std::optional<Row> row(std::int64_t id) const;

  /// The design with these values of the archive's variables, in the order of its columns, as the study has it or under
  /// another modelling choice. The first call looks at all designs; of those recorded after it, none is found.
  [[nodiscard]] std::optional<Row> find(std::span<const Value> variables, std::string_view choice = {}) const;

  /// Calls `take` with each design of a query. Throws std::invalid_argument with what SQLite says of a condition that
  /// is none, or of an order that is no column, and of a condition that takes more than about a second and 0.1 ms a
  /// design.
  void each(const Query& query, const std::function<void(const Row&)>& take) const;

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace coilwright::archive
