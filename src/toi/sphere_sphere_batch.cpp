#include "toi/sphere_sphere_batch.hpp"

namespace carom {

namespace {

inline double code_of(const SphereQuadratic& q)
{
    const double code = certainly_none(q) ? 0.0 : certainly_impact(q) ? 1.0 : 2.0;
    return is_moderate(q) ? code : 2.0;
}

/// Statuses from codes, 2 standing for touching as long as it is open. \returns whether one is open
inline bool statuses(const BatchBlock& b, std::size_t count, const double* code)
{
    ImpactStatus* __restrict status = b.status;
    for (std::size_t i = 0; i < count; ++i)
        status[i] = static_cast<ImpactStatus>(static_cast<unsigned char>(static_cast<int>(code[i])));
    unsigned char any = 0;
    for (std::size_t i = 0; i < count; ++i) any |= static_cast<unsigned char>(status[i]);
    return (any & 2) != 0;
}

// Arrays that overlap nothing: without this word compilers would have to look, and rather not vectorise.
using In = const double* __restrict;
using Out = double* __restrict;

inline void whole(std::size_t count, In rx, In ry, In rz, In vx, In vy, In vz, In s, Out code, Out t, Out t_lo,
                  Out t_hi)
{
    for (std::size_t i = 0; i < count; ++i) {
        const SphereQuadratic q = sphere_quadratic(rx[i], ry[i], rz[i], vx[i], vy[i], vz[i], s[i]);
        const TimeEnclosure time = time_enclosure(q);
        const double c = code_of(q);
        code[i] = c;
        t[i] = c == 1 ? time.t : 0;
        t_lo[i] = c == 1 ? time.lo : 0;
        t_hi[i] = c == 1 ? time.hi : 0;
    }
}

inline void lower(std::size_t count, In rx, In ry, In rz, In vx, In vy, In vz, In s, Out code, Out t_lo)
{
    for (std::size_t i = 0; i < count; ++i) {
        const SphereQuadratic q = sphere_quadratic(rx[i], ry[i], rz[i], vx[i], vy[i], vz[i], s[i]);
        const double low = time_lower_bound(q), c = code_of(q);
        code[i] = c;
        t_lo[i] = c == 1 ? low : 0;
    }
}

inline bool whole(const BatchBlock& b, std::size_t count)
{
    double code[batch_block];
    whole(count, b.rx, b.ry, b.rz, b.vx, b.vy, b.vz, b.s, code, b.t, b.t_lo, b.t_hi);
    return statuses(b, count, code);
}
inline bool lower(const BatchBlock& b, std::size_t count)
{
    double code[batch_block];
    lower(count, b.rx, b.ry, b.rz, b.vx, b.vy, b.vz, b.s, code, b.t_lo);
    return statuses(b, count, code);
}

// The same operations in the same order on wider registers: the same bits. No fma, contraction is off.
#if defined(__x86_64__) && !defined(__AVX2__)
#define CAROM_WIDER 1
[[gnu::target("avx2"), gnu::flatten]] bool whole_wide(const BatchBlock& b, std::size_t count)
{
    return whole(b, count);
}
[[gnu::target("avx2"), gnu::flatten]] bool lower_wide(const BatchBlock& b, std::size_t count)
{
    return lower(b, count);
}
bool has_wider()
{
    static const bool supported = __builtin_cpu_supports("avx2") != 0;
    return supported;
}
#endif

}  // namespace

bool solve_block(const BatchBlock& block, std::size_t count)
{
#ifdef CAROM_WIDER
    if (has_wider()) return whole_wide(block, count);
#endif
    return whole(block, count);
}

bool solve_block_lower(const BatchBlock& block, std::size_t count)
{
#ifdef CAROM_WIDER
    if (has_wider()) return lower_wide(block, count);
#endif
    return lower(block, count);
}

}  // namespace carom
