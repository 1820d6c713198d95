/// \file
/// SQLite as two values that close themselves. Errors are InputError: the file is what is at fault.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace carom::io {

using Bytes = std::vector<unsigned char>;

enum class Access { read, recover, create };

class Database {
public:
    /// \throws InputError "FILE: ..." if it cannot be opened
    Database(const std::filesystem::path& file, Access access);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    /// Statements without results. \throws InputError
    void execute(const char* sql);
    /// The first column of the first row. \throws InputError
    std::string text_of(const char* sql);

    /// Begin of every message.
    std::string file;

private:
    friend class Statement;
    [[noreturn]] void fail() const;
    sqlite3* handle_ = nullptr;
};

class Statement {
public:
    Statement(Database& database, const char* sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    // Parameters and columns count from 0.
    Statement& bind(int i, std::int64_t value);
    Statement& bind(int i, double value);
    Statement& bind(int i, const std::string& text);
    Statement& bind(int i, std::span<const unsigned char> blob);
    /// Is there a (further) row?
    bool step();
    void reset();

    // A column of another type than asked for is damage.
    std::int64_t integer(int i) const;
    double real(int i) const;
    std::string text(int i) const;
    /// Valid until the next step.
    std::span<const unsigned char> blob(int i) const;

    void get(int i, std::int64_t& value) const { value = integer(i); }
    void get(int i, double& value) const { value = real(i); }
    void get(int i, std::string& value) const { value = text(i); }
    void get(int i, Bytes& value) const { value.assign(blob(i).begin(), blob(i).end()); }

private:
    friend class Database;
    void expect(int i, int type) const;
    void check(int code) const;
    Database& database_;
    sqlite3_stmt* handle_ = nullptr;
};

}  // namespace carom::io
