// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/sqlite.h"

#include <utility>

#include <sqlite3.h>

namespace axiscomp::sqlite {

bool Failure::isDamage() const
{
    const int primary = code & 0xff;
    return primary == SQLITE_CORRUPT || primary == SQLITE_NOTADB;
}

Failure Failure::damage(std::string message)
{
    return {.code = SQLITE_CORRUPT, .message = std::move(message)};
}

void Connection::Close::operator()(sqlite3* database) const
{
    ::sqlite3_close_v2(database);
}

Connection::Connection(const std::filesystem::path& file, std::chrono::milliseconds busyWait)
{
    sqlite3* database = nullptr;
    const int code = ::sqlite3_open_v2(file.string().c_str(), &database,
        SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE,
        nullptr);
    m_database.reset(database);
    check(code);
    ::sqlite3_busy_timeout(database, static_cast<int>(busyWait.count()));
}

void Connection::check(int code) const
{
    if (code != SQLITE_OK && code != SQLITE_ROW && code != SQLITE_DONE)
        throw Failure{.code = code,
            .systemError = {::sqlite3_system_errno(m_database.get()), std::system_category()},
            .message = ::sqlite3_errmsg(m_database.get())};
}

void Connection::run(const std::string& statements)
{
    check(::sqlite3_exec(m_database.get(), statements.c_str(), nullptr, nullptr, nullptr));
}

std::int64_t Connection::number(const std::string& query)
{
    Statement statement(*this, query);
    return statement.next() ? statement.number(0) : 0;
}

std::string Connection::text(const std::string& query)
{
    Statement statement(*this, query);
    return statement.next() ? statement.text(0) : std::string();
}

bool Connection::isReadOnly() const
{
    return ::sqlite3_db_readonly(m_database.get(), "main") == 1;
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const
{
    ::sqlite3_finalize(statement);
}

Statement::Statement(Prepared, Connection& connection, std::string_view query)
    : m_connection(connection)
{
    sqlite3_stmt* statement = nullptr;
    const int code = ::sqlite3_prepare_v2(connection.m_database.get(), query.data(),
        static_cast<int>(query.size()), &statement, nullptr);
    m_statement.reset(statement);
    connection.check(code);
}

void Statement::bind(int index, std::int64_t value)
{
    m_connection.check(::sqlite3_bind_int64(m_statement.get(), index, value));
}

void Statement::bind(int index, std::string_view value)
{
    // Never null, which would be NULL instead of an empty text.
    m_connection.check(::sqlite3_bind_text(m_statement.get(), index,
        value.empty() ? "" : value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT));
}

void Statement::bind(int index, const std::optional<std::int64_t>& value)
{
    if (value)
        bind(index, *value);
    else
        m_connection.check(::sqlite3_bind_null(m_statement.get(), index));
}

void Statement::bind(int index, const std::optional<double>& value)
{
    m_connection.check(value ? ::sqlite3_bind_double(m_statement.get(), index, *value)
                             : ::sqlite3_bind_null(m_statement.get(), index));
}

bool Statement::next()
{
    const int code = ::sqlite3_step(m_statement.get());
    m_connection.check(code);
    return code == SQLITE_ROW;
}

bool Statement::isNull(int column) const
{
    return ::sqlite3_column_type(m_statement.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::number(int column) const
{
    return ::sqlite3_column_int64(m_statement.get(), column);
}

std::optional<double> Statement::real(int column) const
{
    return isNull(column) ? std::nullopt
                          : std::optional(::sqlite3_column_double(m_statement.get(), column));
}

std::string Statement::text(int column) const
{
    const auto* const text = ::sqlite3_column_text(m_statement.get(), column);
    const int size = ::sqlite3_column_bytes(m_statement.get(), column);
    return {reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)};
}

int Statement::columns() const
{
    return ::sqlite3_column_count(m_statement.get());
}

void Statement::runWith(const Statement& row)
{
    ::sqlite3_reset(m_statement.get());
    for (int column = 0; column < row.columns(); ++column)
        m_connection.check(::sqlite3_bind_value(
            m_statement.get(), column + 1, ::sqlite3_column_value(row.m_statement.get(), column)));
    run();
}

Transaction::Transaction(Connection& connection, Kind kind) : m_connection(connection)
{
    m_connection.run(kind == Kind::Write ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction()
{
    if (!m_isOpen)
        return;
    try {
        m_connection.run("ROLLBACK");
    } catch (const Failure&) { // SQLite has rolled it back by itself
    }
}

void Transaction::commit()
{
    m_connection.run("COMMIT");
    m_isOpen = false;
}

} // namespace axiscomp::sqlite
