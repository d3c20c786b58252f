// SPDX-License-Identifier: GPL-3.0-or-later
// Body of the explicit kernel for RHEXIS_WIDTH lanes at a time; included once per instruction set, in a namespace of
// its own. Formulas: energy/corotational.hpp and math/rotation.hpp, in float and without branches per lane.
//
// With u = f^2 - I the quartic for f = tr S reads u^2/4 - 2 J f - e2 = 0, its slope is d = u f - 2 J, and
// R = [(u + 2 I) F - 2 F C + 2 f cof F] / d. So with k = (lambda (f - 3) - 2 mu) / d
//   P = F (a 1 - 2 k C) + 2 k f cof F,  a = 2 mu + k (u + 2 I)
// needs neither R nor S. Rest frames are turned so that the first edge lies on x and the second in the x-y plane: the
// material is isotropic, and three of the nine rest gradients vanish.

constexpr int width = RHEXIS_WIDTH;
typedef float Lanes __attribute__((vector_size(4 * width), aligned(4 * width)));
typedef int Mask __attribute__((vector_size(4 * width)));
typedef double Node __attribute__((vector_size(32), aligned(32)));
typedef int ShortMask __attribute__((vector_size(16)));
typedef float ShortNode __attribute__((vector_size(16), aligned(16)));

/// Last steps on f over f below which what is left of the error is below rounding.
constexpr float halley_step = 3e-3F;
constexpr float newton_step = 2e-4F;

struct Vector {
    Lanes x, y, z;
};

inline Lanes load(const float* from) { return *reinterpret_cast<const Lanes*>(from); }
inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }

#if RHEXIS_WIDTH == 16
inline Lanes root(Lanes a) { return reinterpret_cast<Lanes>(_mm512_sqrt_ps(reinterpret_cast<__m512>(a))); }
inline bool any(Mask m) {
    return _mm512_test_epi32_mask(reinterpret_cast<__m512i>(m), reinterpret_cast<__m512i>(m)) != 0;
}
inline Lanes rows(const float* from, const std::uint32_t* offset) {
    __m512 r = _mm512_castps128_ps512(_mm_load_ps(from + offset[0]));
    r = _mm512_insertf32x4(r, _mm_load_ps(from + offset[4]), 1);
    r = _mm512_insertf32x4(r, _mm_load_ps(from + offset[8]), 2);
    return reinterpret_cast<Lanes>(_mm512_insertf32x4(r, _mm_load_ps(from + offset[12]), 3));
}
inline void add_row(float* to, __m128 value) { _mm_store_ps(to, _mm_add_ps(_mm_load_ps(to), value)); }
inline void add_rows(float* to, const std::uint32_t* offset, Lanes value) {
    const __m512 v = reinterpret_cast<__m512>(value);
    add_row(to + offset[0], _mm512_castps512_ps128(v));
    add_row(to + offset[4], _mm512_extractf32x4_ps(v, 1));
    add_row(to + offset[8], _mm512_extractf32x4_ps(v, 2));
    add_row(to + offset[12], _mm512_extractf32x4_ps(v, 3));
}
#define RHEXIS_PICK(a, b, i, j, k, l) \
    reinterpret_cast<Lanes>(          \
        _mm512_shuffle_ps(reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b), _MM_SHUFFLE(l, k, j, i)))
#define RHEXIS_LOW(a, b) \
    reinterpret_cast<Lanes>(_mm512_unpacklo_ps(reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b)))
#define RHEXIS_HIGH(a, b) \
    reinterpret_cast<Lanes>(_mm512_unpackhi_ps(reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b)))
#define RHEXIS_PAIR_LOW(a, b) \
    reinterpret_cast<Lanes>(_mm512_unpacklo_pd(reinterpret_cast<__m512d>(a), reinterpret_cast<__m512d>(b)))
#define RHEXIS_PAIR_HIGH(a, b) \
    reinterpret_cast<Lanes>(_mm512_unpackhi_pd(reinterpret_cast<__m512d>(a), reinterpret_cast<__m512d>(b)))
#elif RHEXIS_WIDTH == 8
inline Lanes root(Lanes a) { return reinterpret_cast<Lanes>(_mm256_sqrt_ps(reinterpret_cast<__m256>(a))); }
inline bool any(Mask m) { return _mm256_movemask_ps(reinterpret_cast<__m256>(m)) != 0; }
inline Lanes rows(const float* from, const std::uint32_t* offset) {
    const __m256 r = _mm256_castps128_ps256(_mm_load_ps(from + offset[0]));
    return reinterpret_cast<Lanes>(_mm256_insertf128_ps(r, _mm_load_ps(from + offset[4]), 1));
}
inline void add_row(float* to, __m128 value) { _mm_store_ps(to, _mm_add_ps(_mm_load_ps(to), value)); }
inline void add_rows(float* to, const std::uint32_t* offset, Lanes value) {
    const __m256 v = reinterpret_cast<__m256>(value);
    add_row(to + offset[0], _mm256_castps256_ps128(v));
    add_row(to + offset[4], _mm256_extractf128_ps(v, 1));
}
#define RHEXIS_PICK(a, b, i, j, k, l) \
    reinterpret_cast<Lanes>(          \
        _mm256_shuffle_ps(reinterpret_cast<__m256>(a), reinterpret_cast<__m256>(b), _MM_SHUFFLE(l, k, j, i)))
#define RHEXIS_LOW(a, b) \
    reinterpret_cast<Lanes>(_mm256_unpacklo_ps(reinterpret_cast<__m256>(a), reinterpret_cast<__m256>(b)))
#define RHEXIS_HIGH(a, b) \
    reinterpret_cast<Lanes>(_mm256_unpackhi_ps(reinterpret_cast<__m256>(a), reinterpret_cast<__m256>(b)))
#define RHEXIS_PAIR_LOW(a, b) \
    reinterpret_cast<Lanes>(_mm256_unpacklo_pd(reinterpret_cast<__m256d>(a), reinterpret_cast<__m256d>(b)))
#define RHEXIS_PAIR_HIGH(a, b) \
    reinterpret_cast<Lanes>(_mm256_unpackhi_pd(reinterpret_cast<__m256d>(a), reinterpret_cast<__m256d>(b)))
#else
inline Lanes root(Lanes a) { return reinterpret_cast<Lanes>(_mm_sqrt_ps(reinterpret_cast<__m128>(a))); }
inline bool any(Mask m) { return _mm_movemask_ps(reinterpret_cast<__m128>(m)) != 0; }
inline Lanes rows(const float* from, const std::uint32_t* offset) {
    return reinterpret_cast<Lanes>(_mm_load_ps(from + offset[0]));
}
inline void add_rows(float* to, const std::uint32_t* offset, Lanes value) {
    float* const place = to + offset[0];
    _mm_store_ps(place, _mm_add_ps(_mm_load_ps(place), reinterpret_cast<__m128>(value)));
}
#define RHEXIS_PICK(a, b, i, j, k, l) \
    reinterpret_cast<Lanes>(          \
        _mm_shuffle_ps(reinterpret_cast<__m128>(a), reinterpret_cast<__m128>(b), _MM_SHUFFLE(l, k, j, i)))
#define RHEXIS_LOW(a, b) \
    reinterpret_cast<Lanes>(_mm_unpacklo_ps(reinterpret_cast<__m128>(a), reinterpret_cast<__m128>(b)))
#define RHEXIS_HIGH(a, b) \
    reinterpret_cast<Lanes>(_mm_unpackhi_ps(reinterpret_cast<__m128>(a), reinterpret_cast<__m128>(b)))
#define RHEXIS_PAIR_LOW(a, b) \
    reinterpret_cast<Lanes>(_mm_unpacklo_pd(reinterpret_cast<__m128d>(a), reinterpret_cast<__m128d>(b)))
#define RHEXIS_PAIR_HIGH(a, b) \
    reinterpret_cast<Lanes>(_mm_unpackhi_pd(reinterpret_cast<__m128d>(a), reinterpret_cast<__m128d>(b)))
#endif

/// Four rows of (x, y, z, w) per 128-bit block become x, y and z of 4 lanes.
inline Vector turn(Lanes r0, Lanes r1, Lanes r2, Lanes r3) {
    const Lanes xy01 = RHEXIS_LOW(r0, r1);
    const Lanes xy23 = RHEXIS_LOW(r2, r3);
    const Lanes z01 = RHEXIS_HIGH(r0, r1);
    const Lanes z23 = RHEXIS_HIGH(r2, r3);
    return {RHEXIS_PAIR_LOW(xy01, xy23), RHEXIS_PAIR_HIGH(xy01, xy23), RHEXIS_PAIR_LOW(z01, z23)};
}

/// The same for w alone.
inline Lanes turn_fourth(Lanes r0, Lanes r1, Lanes r2, Lanes r3) {
    return RHEXIS_PAIR_HIGH(RHEXIS_HIGH(r0, r1), RHEXIS_HIGH(r2, r3));
}

struct Rows {
    Lanes row[4];
};

/// The opposite of turn; the fourth value of a row is anything.
inline Rows turn_back(const Vector& v) {
    const Lanes xy01 = RHEXIS_LOW(v.x, v.y);
    const Lanes xy23 = RHEXIS_HIGH(v.x, v.y);
    return {{RHEXIS_PICK(xy01, v.z, 0, 1, 0, 0), RHEXIS_PICK(xy01, v.z, 2, 3, 1, 1), RHEXIS_PICK(xy23, v.z, 0, 1, 2, 2),
             RHEXIS_PICK(xy23, v.z, 2, 3, 3, 3)}};
}

inline Lanes dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector times(const Vector& a, Lanes x) { return {a.x * x, a.y * x, a.z * x}; }
inline Vector combine(const Vector& a, const Vector& b, Lanes x, Lanes y) {
    return {a.x * x + b.x * y, a.y * x + b.y * y, a.z * x + b.z * y};
}
inline Vector combine(const Vector& a, const Vector& b, const Vector& c, Lanes x, Lanes y, Lanes z) {
    return {a.x * x + b.x * y + c.x * z, a.y * x + b.y * y + c.y * z, a.z * x + b.z * y + c.z * z};
}

/// What tr S follows from, and tr S.
struct Invariants {
    Lanes i1, e2, j2, least;  ///< I, e2, 2 J, smallest slope
    Lanes f;                  ///< tr S
};

/// What one element keeps between the passes over a batch.
struct Strain : Invariants {
    Vector f0, f1, f2;                   ///< columns of F
    Vector q0, q1, q2;                   ///< columns of cof F
    Lanes c00, c11, c22, c01, c02, c12;  ///< F^T F
    Lanes k2, kf, a;                     ///< -2 k, -2 k f and a of the stress
};

/// fourth: set to the sum over the four nodes of the fourth value of their rows, unless it is null.
[[gnu::always_inline]] inline void compute_strain(const Group& group, int lane, const float* probe, Strain& s,
                                                  Lanes* fourth) {
    const std::uint32_t* const n0 = group.offset[0] + lane;
    const Lanes r0 = rows(probe, n0), r1 = rows(probe, n0 + 1), r2 = rows(probe, n0 + 2), r3 = rows(probe, n0 + 3);
    if (fourth != nullptr) {
        *fourth = 4.0F * turn_fourth(r0, r1, r2, r3);
    }
    const auto edge = [&](int a) {
        const std::uint32_t* const n = group.offset[a] + lane;
        const Lanes d0 = rows(probe, n) - r0, d1 = rows(probe, n + 1) - r1, d2 = rows(probe, n + 2) - r2,
                    d3 = rows(probe, n + 3) - r3;
        if (fourth != nullptr) {
            *fourth += turn_fourth(d0, d1, d2, d3);
        }
        return turn(d0, d1, d2, d3);
    };
    const auto b = [&](int k) { return load(group.gradient[k] + lane); };
    const Vector d1 = edge(1), d2 = edge(2), d3 = edge(3);
    s.f0 = times(d1, b(0));
    s.f1 = combine(d1, d2, b(1), b(2));
    s.f2 = combine(d1, d2, d3, b(3), b(4), b(5));
    s.c00 = dot(s.f0, s.f0), s.c11 = dot(s.f1, s.f1), s.c22 = dot(s.f2, s.f2);
    s.c01 = dot(s.f0, s.f1), s.c02 = dot(s.f0, s.f2), s.c12 = dot(s.f1, s.f2);
    s.q0 = cross(s.f1, s.f2);
    s.q1 = cross(s.f2, s.f0);
    s.q2 = cross(s.f0, s.f1);
    s.i1 = (s.c00 + s.c11 + s.c22) + 1e-10F;  // a point has no strain, but neither has it 0/0
    s.e2 = (s.c00 * s.c11 - s.c01 * s.c01) + (s.c00 * s.c22 - s.c02 * s.c02) + (s.c11 * s.c22 - s.c12 * s.c12);
    const Lanes j = dot(s.f0, s.q0);
    s.j2 = j + j;
}

/// One Newton step down the quartic: (u^2/4 - 2 J f - e2) / (u f - 2 J).
inline Lanes trace_step(const Invariants& s, Lanes f) {
    const Lanes u = f * f - s.i1;
    return (0.25F * (u * u) - s.j2 * f - s.e2) / larger(u * f - s.j2, s.least);
}

/// Largest root of the quartic for every element of a batch, from the upper bound sqrt(3 I) down: one Halley step
/// (error (f0 - f)^3; there u = 2 I and the second derivative is 8 I), which is enough for strains below 8 %, then
/// Newton. A lane goes on until its next step would be below rounding; what other lanes do never changes it. The batch
/// is there because every step waits for a division.
template <int batch, typename Element>
inline void find_traces(Element* s) {
    Mask open[batch];
    Mask any_open{};
    for (int b = 0; b < batch; ++b) {
        const Lanes i1 = s[b].i1;
        const Lanes start = root(3.0F * i1);
        const Lanes cube = i1 * start;
        // near the singular set the slope goes to 0: bounded from below, the force stays finite
        s[b].least = 2e-3F * cube;
        const Lanes value = i1 * i1 - s[b].j2 * start - s[b].e2;
        const Lanes slope = (cube + cube) - s[b].j2;
        const Lanes change = (value * slope) / (slope * slope - 4.0F * (value * i1));
        s[b].f = start - change;
        open[b] = change > halley_step * start;
        any_open |= open[b];
    }
    for (int k = 0; k < 12 && any(any_open); ++k) {
        any_open = Mask{};
        for (int b = 0; b < batch; ++b) {
            const Lanes change = trace_step(s[b], s[b].f);
            s[b].f = open[b] ? s[b].f - change : s[b].f;
            open[b] &= change > newton_step * s[b].f;
            any_open |= open[b];
        }
    }
}

/// The factors of the stress, in a pass of their own for the sake of its division. Volume is in the moduli, and their
/// sign is turned: forces come out as they are added. pressure: V times what the nodes add to lambda (f - 3) [nJ].
inline void compute_factors(const Group& group, int lane, Lanes pressure, Strain& s) {
    const Lanes f2 = s.f * s.f;
    const Lanes twice_mu = load(group.twice_mu + lane);
    const Lanes slope = larger((f2 - s.i1) * s.f - s.j2, s.least);
    const Lanes k = (twice_mu - load(group.lambda + lane) * (s.f - 3.0F) + pressure) / slope;
    s.a = twice_mu - k * (f2 + s.i1);
    s.k2 = k + k;
    s.kf = s.k2 * s.f;
}

/// P b_a, added.
[[gnu::always_inline]] inline void add_force(const Group& group, int lane, const Strain& s, float* force) {
    const Lanes k2 = s.k2, kf = s.kf, a = s.a;
    const Lanes m01 = k2 * s.c01, m02 = k2 * s.c02, m12 = k2 * s.c12;
    const Lanes m00 = a + k2 * s.c00, m11 = a + k2 * s.c11, m22 = a + k2 * s.c22;
    const auto column = [&](Lanes x, Lanes y, Lanes z, const Vector& q) {
        const Vector p = combine(s.f0, s.f1, s.f2, x, y, z);
        return Vector{p.x - kf * q.x, p.y - kf * q.y, p.z - kf * q.z};
    };
    const Vector p0 = column(m00, m01, m02, s.q0);
    const Vector p1 = column(m01, m11, m12, s.q1);
    const Vector p2 = column(m02, m12, m22, s.q2);
    const auto b = [&](int i) { return load(group.gradient[i] + lane); };
    const Rows g1 = turn_back(combine(p0, p1, p2, b(0), b(1), b(3)));
    const Rows g2 = turn_back(combine(p1, p2, b(2), b(4)));
    const Rows g3 = turn_back(times(p2, b(5)));
    for (int r = 0; r < 4; ++r) {
        add_rows(force, group.offset[1] + lane + r, g1.row[r]);
        add_rows(force, group.offset[2] + lane + r, g2.row[r]);
        add_rows(force, group.offset[3] + lane + r, g3.row[r]);
        add_rows(force, group.offset[0] + lane + r, -(g1.row[r] + g2.row[r] + g3.row[r]));
    }
}

/// `batch` register widths of elements from element `first` on (16 to a group).
template <int batch>
inline void add_batch(const Group* groups, int first, const float* probe, float* force) {
    Strain strain[batch];
    for (int b = 0; b < batch; ++b) {
        const int element = first + b * width;
        compute_strain(groups[element / lanes], element % lanes, probe, strain[b], nullptr);
    }
    find_traces<batch>(strain);
    for (int b = 0; b < batch; ++b) {
        const int element = first + b * width;
        compute_factors(groups[element / lanes], element % lanes, Lanes{}, strain[b]);
    }
    for (int b = 0; b < batch; ++b) {
        const int element = first + b * width;
        add_force(groups[element / lanes], element % lanes, strain[b], force);
    }
}

void add_forces(const Group* groups, int count, const float* probe, float* force) {
    constexpr int batch = RHEXIS_BATCH;
    int element = 0;
    for (; element + batch * width <= count * lanes; element += batch * width) {
        add_batch<batch>(groups, element, probe, force);
    }
    for (; element < count * lanes; element += width) {
        add_batch<1>(groups, element, probe, force);
    }
}

// --- pressure at nodes ----------------------------------------------------------------------------------------------

/// Traces of a batch, kept, and their volume changes, added to the fourth values of the forces.
template <int batch>
inline void gather_volume(const NodalTask& task, int first) {
    Invariants strain[batch];
    for (int b = 0; b < batch; ++b) {
        const int element = first + b * width;
        Strain whole;
        compute_strain(task.groups[element / lanes], element % lanes, task.probe, whole, nullptr);
        strain[b] = whole;
    }
    find_traces<batch>(strain);
    for (int b = 0; b < batch; ++b) {
        const int element = first + b * width;
        const Group& group = task.groups[element / lanes];
        const int lane = element % lanes;
        *reinterpret_cast<Lanes*>(task.trace + element) = strain[b].f;
        const Lanes change = load(group.quarter + lane) * (strain[b].f - 3.0F);
        for (int a = 0; a < 4; ++a) {
            for (int l = 0; l < width; ++l) {
                task.force[group.offset[a][lane + l] + 3] += change[l];
            }
        }
    }
}

/// Few at a time: there is one division to wait for, and more would not stay in registers.
template <int batch>
inline void add_nodal_batch(const NodalTask& task, int first) {
    Strain strain[batch];
    Lanes pressure[batch];
    for (int b = 0; b < batch; ++b) {
        const int element = first + b * width;
        compute_strain(task.groups[element / lanes], element % lanes, task.probe, strain[b], &pressure[b]);
        strain[b].f = load(task.trace + element);
        strain[b].least = 2e-3F * (strain[b].i1 * root(3.0F * strain[b].i1));
    }
    for (int b = 0; b < batch; ++b) {
        const int element = first + b * width;
        const Group& group = task.groups[element / lanes];
        const int lane = element % lanes;
        compute_factors(group, lane, load(group.quarter + lane) * pressure[b], strain[b]);
    }
    for (int b = 0; b < batch; ++b) {
        const int element = first + b * width;
        add_force(task.groups[element / lanes], element % lanes, strain[b], task.force);
    }
}

void add_nodal_forces(const NodalTask& task) {
    constexpr int batch = RHEXIS_BATCH;
    constexpr int few = 4;
    const int end = task.count * lanes;
    int element = 0;
    for (; element + batch * width <= end; element += batch * width) {
        gather_volume<batch>(task, element);
    }
    for (; element < end; element += width) {
        gather_volume<1>(task, element);
    }
    for (int i = 0; i < task.nodes; ++i) {
        task.probe[4 * i + 3] = task.pressure[i] * task.force[4 * i + 3];
    }
    element = 0;
    for (; element + few * width <= end; element += few * width) {
        add_nodal_batch<few>(task, element);
    }
    for (; element < end; element += width) {
        add_nodal_batch<1>(task, element);
    }
}

void accelerate(const Nodes& nodes, double dt, const double* gravity, double decay) {
    Node* const velocity = reinterpret_cast<Node*>(nodes.velocity);
    ShortNode* const force = reinterpret_cast<ShortNode*>(nodes.force);
    const ShortMask xyz = {-1, -1, -1, 0};
    const Node pull = {gravity[0] * dt, gravity[1] * dt, gravity[2] * dt, 0.0};
    for (int i = 0; i < nodes.count; ++i) {
        const ShortNode kept = reinterpret_cast<ShortNode>(reinterpret_cast<ShortMask>(force[i]) & xyz);
        const Node f = __builtin_convertvector(kept, Node);
        const double rate = dt * nodes.inverse_mass[i];
        velocity[i] = (velocity[i] + f * rate + pull * nodes.weight_share[i]) * decay;
        force[i] = ShortNode{};
    }
}

void move(const Nodes& nodes, double dt, double lag) {
    Node* const position = reinterpret_cast<Node*>(nodes.position);
    const Node* const velocity = reinterpret_cast<const Node*>(nodes.velocity);
    ShortNode* const probe = reinterpret_cast<ShortNode*>(nodes.probe);
    const Node origin = {nodes.origin[0], nodes.origin[1], nodes.origin[2], 0.0};
    for (int i = 0; i < nodes.count; ++i) {
        const Node v = velocity[i];
        const Node x = position[i] + v * dt;
        position[i] = x;
        probe[i] = __builtin_convertvector(x - origin + v * lag, ShortNode);
    }
}
