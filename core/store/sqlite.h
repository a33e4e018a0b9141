// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

struct sqlite3;
struct sqlite3_stmt;

/// A thin layer over the C interface of SQLite. Whatever fails throws a Failure, which the
/// StoreDatabase catches: nothing of it leaves core/store.
namespace axiscomp::sqlite {

struct Failure {
    int code = 0; ///< extended result code
    std::error_code systemError = {}; ///< none where the system has nothing to do with it
    std::string message = {}; ///< SQLite's own words, for the log
    Text reason = {}; ///< in place of what the code says

    /// What the file holds cannot be right.
    [[nodiscard]] bool isDamage() const;
    [[nodiscard]] static Failure damage(std::string message);
};

class Connection {
public:
    /// busyWait: how long a statement waits for another program's. Creates the file.
    Connection(const std::filesystem::path& file, std::chrono::milliseconds busyWait);

    /// Statements without parameters and results, separated by semicolons.
    void run(const std::string& statements);
    /// The first column of the first row; 0 without one.
    [[nodiscard]] std::int64_t number(const std::string& query);
    [[nodiscard]] std::string text(const std::string& query);
    [[nodiscard]] bool isReadOnly() const;

private:
    friend class Statement;
    struct Close {
        void operator()(sqlite3* database) const;
    };
    void check(int code) const;
    std::unique_ptr<sqlite3, Close> m_database;
};

/// A prepared statement with its parameters, in their order (?1, ?2, ...).
class Statement {
public:
    template <typename... Values>
    Statement(Connection& connection, std::string_view query, const Values&... values)
        : Statement(Prepared{}, connection, query)
    {
        int index = 0;
        (bind(++index, values), ...);
    }

    /// Goes to the next row; false after the last.
    bool next();
    void run()
    {
        while (next()) { }
    }

    [[nodiscard]] bool isNull(int column) const;
    [[nodiscard]] std::int64_t number(int column) const;
    template <typename Integer> [[nodiscard]] Integer as(int column) const
    {
        return static_cast<Integer>(number(column));
    }
    [[nodiscard]] std::optional<double> real(int column) const; ///< nothing: NULL
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] int columns() const;
    /// The row of another statement becomes the parameters of this one, which then runs.
    void runWith(const Statement& row);

private:
    struct Prepared { };
    Statement(Prepared, Connection& connection, std::string_view query);
    void bind(int index, std::int64_t value);
    void bind(int index, std::string_view value);
    void bind(int index, const std::optional<std::int64_t>& value);
    void bind(int index, const std::optional<double>& value);
    template <typename Integer, std::enable_if_t<std::is_integral_v<Integer>, int> = 0>
    void bind(int index, Integer value)
    {
        bind(index, static_cast<std::int64_t>(value));
    }
    void bind(int index, const std::string& value) { bind(index, std::string_view(value)); }
    void bind(int index, const char* value) { bind(index, std::string_view(value)); }

    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };
    const Connection& m_connection;
    std::unique_ptr<sqlite3_stmt, Finalize> m_statement;
};

/// BEGIN until commit(); rolled back otherwise.
class Transaction {
public:
    enum class Kind { Read, Write };
    Transaction(Connection& connection, Kind kind);
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction();
    void commit();

private:
    Connection& m_connection;
    bool m_isOpen = true;
};

} // namespace axiscomp::sqlite
