#include "io/sqlite.hpp"

#include "core/printable.hpp"

#include <carom/error.hpp>

#include <sqlite3.h>

namespace carom::io {

namespace {

int flags_of(Access access)
{
    switch (access) {
        case Access::read:
            return SQLITE_OPEN_READONLY;
        case Access::recover:
            return SQLITE_OPEN_READWRITE;
        case Access::create:
            break;
    }
    return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
}

}  // namespace

Database::Database(const std::filesystem::path& path, Access access) : file(path.string())
{
    // One thread uses a connection: no mutex.
    const int code = sqlite3_open_v2(path.c_str(), &handle_, flags_of(access) | SQLITE_OPEN_NOMUTEX, nullptr);
    if (code == SQLITE_OK) return;
    const std::string why = handle_ != nullptr ? sqlite3_errmsg(handle_) : "no memory";
    sqlite3_close(handle_);
    throw InputError({file + ": " + (access == Access::create ? "cannot be written: " : "cannot be read: ") + why});
}

Database::~Database()
{
    sqlite3_close(handle_);
}

void Database::fail() const
{
    const int code = sqlite3_errcode(handle_) & 0xff;
    const bool damaged = code == SQLITE_CORRUPT || code == SQLITE_NOTADB || code == SQLITE_ERROR;
    throw InputError(
        {file + (damaged ? ": damaged: " : ": ") + printable(sqlite3_errmsg(handle_))});  // may quote the file
}

void Database::execute(const char* sql)
{
    if (sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

std::string Database::text_of(const char* sql)
{
    Statement statement(*this, sql);
    if (!statement.step()) return {};
    const auto* text = sqlite3_column_text(statement.handle_, 0);
    return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text));
}

Statement::Statement(Database& database, const char* sql) : database_(database)
{
    check(sqlite3_prepare_v2(database.handle_, sql, -1, &handle_, nullptr));
}

Statement::~Statement()
{
    sqlite3_finalize(handle_);
}

void Statement::check(int code) const
{
    if (code != SQLITE_OK) database_.fail();
}

Statement& Statement::bind(int i, std::int64_t value)
{
    check(sqlite3_bind_int64(handle_, i + 1, value));
    return *this;
}

Statement& Statement::bind(int i, double value)
{
    check(sqlite3_bind_double(handle_, i + 1, value));
    return *this;
}

Statement& Statement::bind(int i, const std::string& text)
{
    check(sqlite3_bind_text64(handle_, i + 1, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind(int i, std::span<const unsigned char> blob)
{
    check(sqlite3_bind_blob64(handle_, i + 1, blob.data(), blob.size(), SQLITE_TRANSIENT));
    return *this;
}

bool Statement::step()
{
    const int code = sqlite3_step(handle_);
    if (code == SQLITE_ROW) return true;
    if (code != SQLITE_DONE) database_.fail();
    return false;
}

void Statement::reset()
{
    sqlite3_reset(handle_);
}

void Statement::expect(int i, int type) const
{
    if (sqlite3_column_type(handle_, i) != type)
        throw InputError({database_.file + ": damaged: a value of the wrong type in " + sqlite3_sql(handle_)});
}

std::int64_t Statement::integer(int i) const
{
    expect(i, SQLITE_INTEGER);
    return sqlite3_column_int64(handle_, i);
}

double Statement::real(int i) const
{
    expect(i, SQLITE_FLOAT);
    return sqlite3_column_double(handle_, i);
}

std::string Statement::text(int i) const
{
    expect(i, SQLITE_TEXT);
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(handle_, i));
    return {text, static_cast<std::size_t>(sqlite3_column_bytes(handle_, i))};
}

std::span<const unsigned char> Statement::blob(int i) const
{
    expect(i, SQLITE_BLOB);
    const auto* data = static_cast<const unsigned char*>(sqlite3_column_blob(handle_, i));
    return {data, static_cast<std::size_t>(sqlite3_column_bytes(handle_, i))};
}

}  // namespace carom::io
