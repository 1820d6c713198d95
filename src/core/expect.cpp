#include <cstdio>
#include <cstdlib>

namespace carom::detail {

[[noreturn]] void expectation_failed(const char* condition, const char* file, int line);

void expectation_failed(const char* condition, const char* file, int line)
{
    std::fprintf(stderr, "carom: bug: expectation failed at %s:%d: %s\n", file, line, condition);
    std::abort();
}

}  // namespace carom::detail
