#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "archive/schema.hpp"
#include "coilwright/archive/contents.hpp"
#include "coilwright/archive/row.hpp"

namespace coilwright::archive {

/// Binds the values of a statement one after the other.
class Binder {
 public:
  explicit Binder(SQLite::Statement& statement) : statement_(&statement) {}

  Binder& text(std::string_view value) {
    statement_->bind(++index_, std::string(value));
    return *this;
  }
  /// A text that stays where it is until the statement is done: it is not copied.
  Binder& lasting(const std::string& value) {
    statement_->bindNoCopy(++index_, value);
    return *this;
  }
  Binder& bytes(const std::string& value) {
    statement_->bind(++index_, value.data(), static_cast<int>(value.size()));
    return *this;
  }
  Binder& integer(std::integral auto value) {
    statement_->bind(++index_, static_cast<std::int64_t>(value));
    return *this;
  }
  template <std::integral Integer>
  Binder& integer(const std::optional<Integer>& value) {
    return value ? integer(*value) : none();
  }
  Binder& number(double value) {
    statement_->bind(++index_, value);
    return *this;
  }
  Binder& number(const std::optional<double>& value) { return value ? number(*value) : none(); }
  Binder& none() {
    statement_->bind(++index_);
    return *this;
  }

 private:
  SQLite::Statement* statement_;
  int index_ = 0;
};

/// Binds a design, which must outlive the execution, to `insertion_of` the table and the columns of its archive.
void bind_row(SQLite::Statement& insertion, Designs table, const Row& row, std::int64_t id, std::int64_t run);

/// How many columns of each role an archive has.
struct ColumnCounts {
  std::size_t choices{};  ///< 1 where designs are under another modelling choice
  std::size_t variables{}, objectives{}, constraints{}, quantities{};
};

/// Of these columns.
[[nodiscard]] ColumnCounts counts_of(Designs table, const std::vector<Column>& columns);

/// A design from a row of `selection_of` so many columns.
[[nodiscard]] Row row_of(const SQLite::Statement& selected, const ColumnCounts& counts);

}  // namespace coilwright::archive
