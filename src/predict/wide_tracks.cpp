#include "predict/wide_tracks.hpp"

#include <algorithm>
#include <bit>

#if defined(__x86_64__)

#include <immintrin.h>

namespace carom {

namespace {

#define CAROM_WIDE [[gnu::target("avx2,fma")]]
#define CAROM_WIDE_LAMBDA __attribute__((target("avx2,fma")))

/// Four tracks, a register for each of their members.
struct Wide {
    __m256d x, y, z, vx, vy, vz, reach;
    __m256i kind;  ///< acceleration and is_parabola
};

/// Members 2 k and 2 k + 1 of two tracks, side by side.
CAROM_WIDE inline __m256d beside(const double* low, const double* high, int k)
{
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(low + 2 * k)), _mm_load_pd(high + 2 * k), 1);
}

/// The eight numbers of a track, the last of them its kind.
inline const double* numbers(const Track* track)
{
    return reinterpret_cast<const double*>(track);
}

CAROM_WIDE inline Wide load(const Track* tracks, const BodyId* ids)
{
    const double *t0 = numbers(tracks + ids[0]), *t1 = numbers(tracks + ids[1]), *t2 = numbers(tracks + ids[2]),
                 *t3 = numbers(tracks + ids[3]);
    const __m256d a0 = beside(t0, t2, 0), b0 = beside(t1, t3, 0), a1 = beside(t0, t2, 1), b1 = beside(t1, t3, 1),
                  a2 = beside(t0, t2, 2), b2 = beside(t1, t3, 2), a3 = beside(t0, t2, 3), b3 = beside(t1, t3, 3);
    return {_mm256_unpacklo_pd(a0, b0), _mm256_unpackhi_pd(a0, b0),
            _mm256_unpacklo_pd(a1, b1), _mm256_unpackhi_pd(a1, b1),
            _mm256_unpacklo_pd(a2, b2), _mm256_unpackhi_pd(a2, b2),
            _mm256_unpacklo_pd(a3, b3), _mm256_castpd_si256(_mm256_unpackhi_pd(a3, b3))};
}

CAROM_WIDE inline __m256d dot(__m256d ax, __m256d ay, __m256d az, __m256d bx, __m256d by, __m256d bz)
{
    return _mm256_fmadd_pd(az, bz, _mm256_fmadd_pd(ay, by, _mm256_mul_pd(ax, bx)));
}

/// Calls answer(ids, keep) for each four of `near`, the last of them filled up; bits of `keep` tell which are meant.
template <class Answer>
CAROM_WIDE inline void by_fours(std::span<const BodyId> near, const Answer& answer)
{
    std::size_t i = 0;
    for (; i + 4 <= near.size(); i += 4) answer(near.data() + i, 15u);
    if (i == near.size()) return;
    BodyId last[4];
    for (std::size_t k = 0; k < 4; ++k) last[k] = near[std::min(i + k, near.size() - 1)];
    answer(last, (1u << (near.size() - i)) - 1);
}

CAROM_WIDE inline unsigned others(const Wide& w, __m256i kind)
{
    return ~static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(_mm256_cmpeq_epi64(w.kind, kind))));
}

CAROM_WIDE inline __m256i kind_of(const Track& track)
{
    return _mm256_set1_epi64x(static_cast<long long>(static_cast<std::uint32_t>(track.acceleration)) |
                              (static_cast<long long>(track.is_parabola) << 32));
}

template <bool gravity>
CAROM_WIDE std::size_t find(const Track* tracks, BodyId body, double age, double least_square,
                            std::span<const BodyId> near, Meeting* found)
{
    const Track& own = tracks[body];
    const __m256d x = _mm256_set1_pd(own.place[0]), y = _mm256_set1_pd(own.place[1]), z = _mm256_set1_pd(own.place[2]),
                  vx = _mm256_set1_pd(own.velocity[0]), vy = _mm256_set1_pd(own.velocity[1]),
                  vz = _mm256_set1_pd(own.velocity[2]), reach = _mm256_set1_pd(own.reach), t = _mm256_set1_pd(age),
                  shrink = _mm256_set1_pd(1 - track_rounding), least = _mm256_set1_pd(least_square),
                  certain = _mm256_set1_pd(certain_separation), zero = _mm256_setzero_pd();
    const __m256i kind = kind_of(own);
    std::size_t count = 0;
    by_fours(near, [&](const BodyId* four, unsigned keep) CAROM_WIDE_LAMBDA {
        const Wide w = load(tracks, four);
        const __m256d ux = _mm256_sub_pd(vx, w.vx), uy = _mm256_sub_pd(vy, w.vy), uz = _mm256_sub_pd(vz, w.vz);
        const __m256d rx = _mm256_fmadd_pd(t, ux, _mm256_sub_pd(x, w.x)),
                      ry = _mm256_fmadd_pd(t, uy, _mm256_sub_pd(y, w.y)),
                      rz = _mm256_fmadd_pd(t, uz, _mm256_sub_pd(z, w.z));
        const __m256d approach = dot(rx, ry, rz, ux, uy, uz), square = dot(rx, ry, rz, rx, ry, rz),
                      speed = dot(ux, uy, uz, ux, uy, uz), sum = _mm256_add_pd(reach, w.reach);
        const __m256d gap = _mm256_fmsub_pd(square, shrink, _mm256_mul_pd(sum, sum));
        const __m256d approach_square = _mm256_mul_pd(approach, approach);
        const __m256d discriminant = _mm256_fnmadd_pd(speed, gap, approach_square);
        const __m256d apart = _mm256_cmp_pd(gap, zero, _CMP_GT_OQ);
        const __m256d separate = _mm256_and_pd(
            _mm256_cmp_pd(approach, zero, _CMP_GE_OQ),
            _mm256_or_pd(apart, _mm256_cmp_pd(approach_square, _mm256_mul_pd(certain, _mm256_mul_pd(square, speed)),
                                              _CMP_GT_OQ)));
        const __m256d passes = _mm256_and_pd(apart, _mm256_cmp_pd(discriminant, zero, _CMP_LT_OQ));
        __m256d out = _mm256_or_pd(separate, passes);
        __m256d now = _mm256_cmp_pd(gap, zero, _CMP_LE_OQ);
        if constexpr (gravity) {
            const __m256d turned = _mm256_cmp_pd(speed, least, _CMP_LE_OQ);
            out = _mm256_andnot_pd(turned, out);
            now = _mm256_or_pd(now, turned);
        }
        const unsigned strange = others(w, kind);
        unsigned left = (~static_cast<unsigned>(_mm256_movemask_pd(out)) | strange) & keep;
        if (left == 0) return;
        alignas(32) double soonest[4];
        const __m256d time = _mm256_div_pd(gap, _mm256_sub_pd(_mm256_sqrt_pd(discriminant), approach));
        _mm256_store_pd(soonest, _mm256_andnot_pd(now, time));
        for (; left != 0; left &= left - 1) {
            const int k = std::countr_zero(left);
            found[count++] = {(strange >> k) & 1 ? Meeting::unknown : soonest[k], four[k]};
        }
    });
    return count;
}

CAROM_WIDE std::size_t find_in_reach(const Track* tracks, const Track& own, double age, std::span<const BodyId> near,
                                     BodyId* found)
{
    // Only of bodies without acceleration: others are asked for one by one.
    const __m256d x = _mm256_set1_pd(own.place[0]), y = _mm256_set1_pd(own.place[1]), z = _mm256_set1_pd(own.place[2]),
                  reach = _mm256_set1_pd(own.reach), t = _mm256_set1_pd(age),
                  shrink = _mm256_set1_pd(1 - track_rounding);
    const __m256i kind = kind_of(Track{.acceleration = Accelerations::none, .is_parabola = 1});
    std::size_t count = 0;
    by_fours(near, [&](const BodyId* four, unsigned keep) CAROM_WIDE_LAMBDA {
        const Wide w = load(tracks, four);
        const __m256d rx = _mm256_fnmadd_pd(t, w.vx, _mm256_sub_pd(x, w.x)),
                      ry = _mm256_fnmadd_pd(t, w.vy, _mm256_sub_pd(y, w.y)),
                      rz = _mm256_fnmadd_pd(t, w.vz, _mm256_sub_pd(z, w.z));
        const __m256d square = dot(rx, ry, rz, rx, ry, rz), sum = _mm256_add_pd(reach, w.reach);
        const __m256d apart = _mm256_cmp_pd(_mm256_mul_pd(square, shrink), _mm256_mul_pd(sum, sum), _CMP_GT_OQ);
        unsigned left = (~static_cast<unsigned>(_mm256_movemask_pd(apart)) | others(w, kind)) & keep;
        for (; left != 0; left &= left - 1) found[count++] = four[std::countr_zero(left)];
    });
    return count;
}

}  // namespace

// Callers know nothing of the registers.
template <bool gravity>
std::size_t find_wide(const Track* tracks, BodyId body, double age, double least_square, std::span<const BodyId> near,
                      Meeting* found)
{
    return find<gravity>(tracks, body, age, least_square, near, found);
}

std::size_t in_reach_wide(const Track* tracks, const Track& own, double age, std::span<const BodyId> near,
                          BodyId* found)
{
    return find_in_reach(tracks, own, age, near, found);
}

template std::size_t find_wide<true>(const Track*, BodyId, double, double, std::span<const BodyId>, Meeting*);
template std::size_t find_wide<false>(const Track*, BodyId, double, double, std::span<const BodyId>, Meeting*);

bool has_wide_registers()
{
    static const bool supported = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
    return supported;
}

}  // namespace carom

#else

namespace carom {

template <bool gravity>
std::size_t find_wide(const Track*, BodyId, double, double, std::span<const BodyId>, Meeting*)
{
    return 0;
}
template std::size_t find_wide<true>(const Track*, BodyId, double, double, std::span<const BodyId>, Meeting*);
template std::size_t find_wide<false>(const Track*, BodyId, double, double, std::span<const BodyId>, Meeting*);
std::size_t in_reach_wide(const Track*, const Track&, double, std::span<const BodyId>, BodyId*)
{
    return 0;
}
bool has_wide_registers()
{
    return false;
}

}  // namespace carom

#endif
