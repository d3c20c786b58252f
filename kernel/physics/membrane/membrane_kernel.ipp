// SPDX-License-Identifier: GPL-3.0-or-later
// Body of the kernel of membranes for RHEXIS_WIDTH doubles at a time; included once per instruction set, in a namespace
// of its own. Formulas: energy/membrane_triangle.hpp, energy/metric_strain.hpp, energy/tension_field.hpp.

#include "physics/solve/lanes.ipp"

constexpr int row_length = (3 * 3 + 6 * 9 + lanes - 1) / lanes * lanes;  // of what a triangle writes

struct Plane {
    Lanes x, y;
};

/// In the order 00, 01, 02, 11, 12, 22.
struct Symmetric {
    Lanes xx, xy, xz, yy, yz, zz;
};
inline Vector operator*(const Symmetric& m, const Vector& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
}
inline Symmetric operator*(const Symmetric& m, Lanes s) {
    return {m.xx * s, m.xy * s, m.xz * s, m.yy * s, m.yz * s, m.zz * s};
}
inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// m += s (a b' + b a').
inline void add_both(Symmetric& m, const Vector& a, const Vector& b, Lanes s) {
    m.xx += s * (2.0 * (a.x * b.x));
    m.yy += s * (2.0 * (a.y * b.y));
    m.zz += s * (2.0 * (a.z * b.z));
    m.xy += s * (a.x * b.y + a.y * b.x);
    m.xz += s * (a.x * b.z + a.z * b.x);
    m.yz += s * (a.y * b.z + a.z * b.y);
}

inline Lanes either(Mask m, Lanes a, Lanes b) { return m ? a : b; }
inline Vector either(Mask m, const Vector& a, const Vector& b) {
    return {either(m, a.x, b.x), either(m, a.y, b.y), either(m, a.z, b.z)};
}

// --- strain from the metric ------------------------------------------------------------------------------------------

struct Strain {
    Vector metric;
    Lanes root, d, t;
    Vector minor, d1, t1;     ///< by the metric
    Vector value;             ///< (11, 22, shear)
    Vector by11, by22, by12;  ///< its rows: of each strain by the metric
};

inline Strain strain_of(const Vector& c) {
    constexpr double corner = 1e-6;
    const double at_rest = __builtin_sqrt(1.0 + corner) - 1.0;
    const Lanes zero = all(0.0), one = all(1.0);
    Strain s;
    s.metric = c;
    s.root = root(larger(c.x * c.y - c.z * c.z, zero) + corner);
    s.d = s.root - at_rest;
    s.t = root(c.x + c.y + 2.0 * s.d);
    s.minor = {c.y, c.x, -2.0 * c.z};
    s.d1 = s.minor * (0.5 / s.root);
    s.t1 = Vector{one + 2.0 * s.d1.x, one + 2.0 * s.d1.y, 2.0 * s.d1.z} * (0.5 / s.t);
    const Lanes share = one / s.t;
    const Lanes u11 = (c.x + s.d) * share, u22 = (c.y + s.d) * share, u12 = 2.0 * c.z * share;
    s.value = {u11 - 1.0, u22 - 1.0, u12};
    s.by11 = Vector{one + s.d1.x - u11 * s.t1.x, s.d1.y - u11 * s.t1.y, s.d1.z - u11 * s.t1.z} * share;
    s.by22 = Vector{s.d1.x - u22 * s.t1.x, one + s.d1.y - u22 * s.t1.y, s.d1.z - u22 * s.t1.z} * share;
    s.by12 = Vector{-u12 * s.t1.x, -u12 * s.t1.y, 2.0 - u12 * s.t1.z} * share;
    return s;
}

/// From what goes with the strain to what goes with the metric.
inline Vector on_metric(const Strain& s, const Vector& v) { return s.by11 * v.x + s.by22 * v.y + s.by12 * v.z; }

inline Symmetric on_metric(const Strain& s, const Symmetric& m) {
    // columns of m times the rows, then the rows' transpose times that
    const auto column = [&](Lanes Vector::*k) { return on_metric(s, m * Vector{s.by11.*k, s.by22.*k, s.by12.*k}); };
    const Vector x = column(&Vector::x), y = column(&Vector::y), z = column(&Vector::z);
    return {x.x, y.x, z.x, y.y, z.y, z.z};
}

/// Adds stress times the second derivative of the strain.
inline void add_bending_of_strain(const Strain& s, const Vector& stress, Symmetric& m) {
    const Lanes share = 1.0 / s.t;
    const Lanes both = stress.x + stress.y;
    // d2 = minor2 / (2 root) - minor minor' / (4 root^3)
    const Lanes half = 0.5 / s.root;
    const Lanes cubed = 0.25 / (s.root * s.root * s.root);
    Symmetric d2{-(cubed * (s.minor.x * s.minor.x)), half - cubed * (s.minor.x * s.minor.y),
                 -(cubed * (s.minor.x * s.minor.z)), -(cubed * (s.minor.y * s.minor.y)),
                 -(cubed * (s.minor.y * s.minor.z)), -2.0 * half - cubed * (s.minor.z * s.minor.z)};
    const Vector n1{stress.x + both * s.d1.x, stress.y + both * s.d1.y, 2.0 * stress.z + both * s.d1.z};
    const Lanes n = stress.x * (s.metric.x + s.d) + stress.y * (s.metric.y + s.d) + stress.z * (2.0 * s.metric.z);
    const Lanes square = share * share;
    const Lanes own = both * share - n * square * share;  // on d2, with - t2 = (t1 t1' - d2) / t
    const Symmetric bent = d2 * own;
    m = {m.xx + bent.xx, m.xy + bent.xy, m.xz + bent.xz, m.yy + bent.yy, m.yz + bent.yz, m.zz + bent.zz};
    add_both(m, n1, s.t1, -square);
    add_both(m, s.t1, s.t1, 1.5 * n * square * share);  // half of 2 + 1: both adds twice
}

// --- tension field ---------------------------------------------------------------------------------------------------

struct Field {
    Vector stress;
    Symmetric tangent;
};

struct Wrinkles {
    Lanes depth, stiffness;
    Vector stress;
};

inline Vector spread(const Plane& n) { return {n.x * n.x, n.y * n.y, 2.0 * n.x * n.y}; }
inline Vector turn(const Plane& n) { return {-2.0 * n.x * n.y, 2.0 * n.x * n.y, 2.0 * (n.x * n.x - n.y * n.y)}; }

inline Wrinkles wrinkles_along(const Plane& n, const Vector& stress, const Symmetric& stiffness) {
    Wrinkles w;
    const Vector nn = spread(n);
    const Vector answer = stiffness * nn;
    w.stiffness = dot(nn, answer);
    w.depth = -dot(nn, stress) / w.stiffness;
    w.stress = stress + answer * w.depth;
    return w;
}

inline Plane turned(const Plane& n, Lanes angle) {
    const Lanes square = 0.25 * (angle * angle);
    const Lanes whole = 1.0 / (1.0 + square);
    const Lanes c = (1.0 - square) * whole, s = angle * whole;
    return {c * n.x - s * n.y, s * n.x + c * n.y};
}

inline Lanes energy_of(const Wrinkles& w) { return -0.5 * (w.depth * w.depth * w.stiffness); }

/// Newton's method on the angle; lanes stop for themselves, so that their neighbours do not matter.
inline Wrinkles deepest_wrinkles(Mask active, Plane& n, const Vector& stress, const Symmetric& stiffness) {
    Wrinkles w = wrinkles_along(n, stress, stiffness);
    Lanes energy = energy_of(w);
    for (int i = 0; i < 30; ++i) {
        const Vector v = turn(n);
        const Vector answer = stiffness * v;
        const Lanes cross = dot(spread(n), answer);
        const Lanes slope = w.depth * dot(v, w.stress);
        const Lanes curvature = w.depth * w.depth * (dot(v, answer) - cross * cross / w.stiffness) +
                                2.0 * w.depth * (w.stress.x + w.stress.y);
        Lanes step = -slope / larger(absolute(curvature), all(1e-300));
        step = step > 0.5 ? all(0.5) : step < -0.5 ? all(-0.5) : step;
        active = active & (step * step > 1e-24);
        if (!any(active)) {
            break;
        }
        Plane next = turned(n, step);
        Wrinkles there = wrinkles_along(next, stress, stiffness);
        Lanes energy_there = energy_of(there);
        for (int half = 0; half < 8; ++half) {
            const Mask uphill = active & ((energy_there > energy) | (there.depth < 0.0));
            if (!any(uphill)) {
                break;
            }
            step = uphill ? 0.5 * step : step;
            next = turned(n, step);
            there = wrinkles_along(next, stress, stiffness);
            energy_there = energy_of(there);
        }
        active = active & (energy_there <= energy);
        n = {either(active, next.x, n.x), either(active, next.y, n.y)};
        w.depth = either(active, there.depth, w.depth);
        w.stiffness = either(active, there.stiffness, w.stiffness);
        w.stress = either(active, there.stress, w.stress);
        energy = either(active, energy_there, energy);
    }
    return w;
}

/// The sheet's stiffness less what following wrinkles give back.
inline Symmetric wrinkled_tangent(const Plane& n, const Wrinkles& w, Lanes along, const Symmetric& stiffness) {
    const Vector nn = spread(n), v = turn(n);
    const Vector a = stiffness * nn, b = stiffness * v;
    const Lanes mixed = dot(nn, b);
    const Lanes turning = dot(v, b) + 2.0 * along / w.depth;
    const Lanes inverse = 1.0 / (w.stiffness * turning - mixed * mixed);
    Symmetric result = stiffness;
    add_both(result, a, a, -0.5 * (turning * inverse));
    add_both(result, a, b, mixed * inverse);
    add_both(result, b, b, -0.5 * (w.stiffness * inverse));
    return result;
}

inline Symmetric either(Mask m, const Symmetric& a, const Symmetric& b) {
    return {either(m, a.xx, b.xx), either(m, a.xy, b.xy), either(m, a.xz, b.xz),
            either(m, a.yy, b.yy), either(m, a.yz, b.yz), either(m, a.zz, b.zz)};
}

inline Symmetric blend(const Symmetric& a, Lanes s, const Symmetric& b, Lanes r) {
    return {s * a.xx + r * b.xx, s * a.xy + r * b.xy, s * a.xz + r * b.xz,
            s * a.yy + r * b.yy, s * a.yz + r * b.yz, s * a.zz + r * b.zz};
}

/// Direction of the least stress; returns the lanes in which that is compressive.
inline Mask compressed(const Vector& stress, Plane& n) {
    const Lanes half = 0.5 * (stress.x - stress.y);
    const Lanes radius = root(half * half + stress.z * stress.z);
    const Mask first = half > 0.0;
    const Lanes x = first ? -stress.z : half - radius;
    const Lanes y = first ? half + radius : stress.z;
    const Lanes length = root(x * x + y * y);
    const Mask long_enough = length > 0.0;
    n = {long_enough ? x / length : all(1.0), long_enough ? y / length : all(0.0)};
    return 0.5 * (stress.x + stress.y) - radius < 0.0;
}

inline Field tension_field(const Vector& strain, const Symmetric& stiffness, Lanes rest, bool with_tangent) {
    Field field{stiffness * strain, stiffness};
    Plane n;
    const Mask loose = compressed(field.stress, n) & (rest < 1.0);
    if (!any(loose)) {
        return field;
    }
    const Wrinkles w = deepest_wrinkles(loose, n, field.stress, stiffness);
    const Lanes along = w.stress.x + w.stress.y;
    const Lanes kept = along > 0.0 ? 1.0 - rest : all(0.0);  // 0: slack
    if (with_tangent) {
        const Mask wrinkled = along > 0.0;
        const Symmetric own = either(wrinkled, wrinkled_tangent(n, w, along, stiffness), stiffness);
        field.tangent = either(loose, blend(stiffness, rest, own, kept), stiffness);
    }
    const Vector stress = field.stress * rest + w.stress * kept;
    field.stress = either(loose, stress, field.stress);
    return field;
}

// --- triangles -------------------------------------------------------------------------------------------------------

/// Stress on the metric as a matrix of the plane: xx, yy, xy.
inline Vector as_matrix(const Vector& s) { return {2.0 * s.x, 2.0 * s.y, s.z}; }

inline Plane times(const Vector& s, const Plane& g) { return {s.x * g.x + s.z * g.y, s.z * g.x + s.y * g.y}; }

/// Without its negative part.
inline Vector tensile(const Vector& s) {
    const Lanes mean = 0.5 * (s.x + s.y), half = 0.5 * (s.x - s.y);
    const Lanes radius = root(half * half + s.z * s.z);
    const Lanes most = mean + radius;
    const Lanes share = 0.5 / radius;
    const Vector projected{most * (0.5 + half * share), most * (0.5 - half * share), most * (s.z * share)};
    const Vector zero{all(0.0), all(0.0), all(0.0)};
    return either(mean - radius >= 0.0, s, either(most <= 0.0, zero, projected));
}

struct Triangle {
    Plane gradient[3];
    Lanes volume;
    Vector f1, f2;  ///< columns of the deformation gradient
};

inline Triangle triangle_at(const double* data, const int* rows, const double* position) {
    Triangle t;
    for (int a = 0; a < 3; ++a) {
        t.gradient[a] = {load(data + lanes * (2 * a)), load(data + lanes * (2 * a + 1))};
    }
    t.volume = load(data + lanes * 6);
    // differences first: positions far from the origin lose no digits
    const Vector origin = gather(position, rows);
    const Vector one = gather(position, rows + lanes) - origin;
    const Vector two = gather(position, rows + 2 * lanes) - origin;
    t.f1 = one * t.gradient[1].x + two * t.gradient[2].x;
    t.f2 = one * t.gradient[1].y + two * t.gradient[2].y;
    return t;
}

/// Columns of f1 u' + f2 w' with u, w given by m, and `own` on the diagonal.
inline void put_block(const Triangle& t, Lanes m11, Lanes m12, Lanes m21, Lanes m22, Lanes own, Writer& out) {
    const Vector u = t.f1 * m11 + t.f2 * m21, w = t.f1 * m12 + t.f2 * m22;
    const Lanes zero = all(0.0);
    out.put(u * t.f1.x + w * t.f2.x + Vector{own, zero, zero});
    out.put(u * t.f1.y + w * t.f2.y + Vector{zero, own, zero});
    out.put(u * t.f1.z + w * t.f2.z + Vector{zero, zero, own});
}

/// d: tangent by the metric; s: stress as a matrix.
inline void put_stiffness(const Triangle& t, const Symmetric& d, const Vector& s, Lanes volume, Writer& out) {
    for (int b = 0; b < 3; ++b) {
        const Plane& g = t.gradient[b];
        // the metric's change with x_b: 2 gx f1, 2 gy f2, gx f2 + gy f1
        const Lanes gx = 2.0 * g.x, gy = 2.0 * g.y;
        const Vector by1{d.xx * gx + d.xz * g.y, d.xy * gx + d.yz * g.y, d.xz * gx + d.zz * g.y};
        const Vector by2{d.xy * gy + d.xz * g.x, d.yy * gy + d.yz * g.x, d.yz * gy + d.zz * g.x};
        const Plane sg = times(s, g);
        for (int a = 0; a <= b; ++a) {
            const Plane& h = t.gradient[a];
            const Lanes hx = 2.0 * h.x, hy = 2.0 * h.y;
            put_block(t, volume * (hx * by1.x + h.y * by1.z), volume * (hx * by2.x + h.y * by2.z),
                      volume * (hy * by1.y + h.x * by1.z), volume * (hy * by2.y + h.x * by2.z),
                      volume * (h.x * sg.x + h.y * sg.y), out);
        }
    }
}

inline void compute(const Task& task, const double* data, const int* index, double* to) {
    const Triangle t = triangle_at(data, index, task.position);
    const Strain strain = strain_of({dot(t.f1, t.f1), dot(t.f2, t.f2), dot(t.f1, t.f2)});
    const double* const k = data + lanes * 7;
    const Symmetric stiffness{
        load(k), load(k + lanes), load(k + 2 * lanes), load(k + 3 * lanes), load(k + 4 * lanes), load(k + 5 * lanes)};
    const bool with_tangent = task.mode != Mode::forces;
    const Field field = tension_field(strain.value, stiffness, load(k + 6 * lanes), with_tangent);
    Vector s = as_matrix(on_metric(strain, field.stress));
    Writer out(to, row_length);
    for (const Plane& g : t.gradient) {
        const Plane pull = times(s, g);
        out.put(t.f1 * (-t.volume * pull.x) + t.f2 * (-t.volume * pull.y));
    }
    if (with_tangent) {
        Symmetric d = on_metric(strain, field.tangent);
        if (task.mode == Mode::consistent) {
            add_bending_of_strain(strain, field.stress, d);
        } else {
            s = tensile(s);
        }
        put_stiffness(t, d, s, t.volume * task.scale, out);
    }
    out.finish();
}

void assemble(const Task& task) {
    double buffer[lanes * row_length];
    const int pairs = task.mode == Mode::forces ? 0 : 6;
    for (int group = 0; group < task.groups; ++group) {
        const double* const data = task.data + static_cast<long>(numbers * lanes) * group;
        const int* const index = task.index + static_cast<long>(places * lanes) * group;
        for (int lane = 0; lane < lanes; lane += width) {
            compute(task, data + lane, index + lane, buffer + static_cast<long>(row_length) * lane);
        }
        for (int l = 0; l < lanes; ++l) {
            add_to_rows(buffer + static_cast<long>(row_length) * l, index + l, 3, pairs, task.force, task.stiffness);
        }
    }
}
