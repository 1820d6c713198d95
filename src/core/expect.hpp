/// \file
/// CAROM_EXPECT: a condition whose failure is a bug in carom, never bad input. On in debug and sanitizer builds and
/// wherever CAROM_EXPECTATIONS is defined; elsewhere it costs nothing.
#pragma once

#if !defined(NDEBUG) || defined(CAROM_EXPECTATIONS)
namespace carom::detail {
[[noreturn]] void expectation_failed(const char* condition, const char* file, int line);
}
#define CAROM_EXPECT(condition) \
    ((condition) ? static_cast<void>(0) : ::carom::detail::expectation_failed(#condition, __FILE__, __LINE__))
#else
#define CAROM_EXPECT(condition) static_cast<void>(0)
#endif
