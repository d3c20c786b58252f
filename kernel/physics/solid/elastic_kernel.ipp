// SPDX-License-Identifier: GPL-3.0-or-later
// Body of the elastic kernel for RHEXIS_WIDTH doubles at a time; included once per instruction set, in a namespace of
// its own. Formulas: energy/corotational.hpp and math/rotation.hpp.

#include "physics/solve/lanes.ipp"

/// By columns.
struct Matrix {
    Vector x, y, z;
};
inline Vector operator*(const Matrix& m, const Vector& v) {
    return {m.x.x * v.x + m.y.x * v.y + m.z.x * v.z, m.x.y * v.x + m.y.y * v.y + m.z.y * v.z,
            m.x.z * v.x + m.y.z * v.y + m.z.z * v.z};
}

struct Symmetric {
    Lanes xx, yy, zz, xy, xz, yz;
};
inline Vector operator*(const Symmetric& m, const Vector& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

// --- rotation --------------------------------------------------------------------------------------------------------

/// Largest root of the quartic, from above. Lanes stop for themselves, so that their neighbours do not matter.
inline Lanes trace_of_stretch(Lanes i1, Lanes e2, Lanes j) {
    Lanes f = root(3.0 * i1);
    for (int k = 0; k < 50; ++k) {
        const Lanes sigma = 0.5 * (f * f) - 0.5 * i1;
        const Lanes value = sigma * sigma - 2.0 * (j * f) - e2;
        const Lanes slope = 2.0 * (sigma * f - j);
        const Lanes next = f - value / slope;
        const Mask falls = (slope > 0.0) & (value > 0.0) & (next < f);
        if (!any(falls)) {
            break;
        }
        f = falls ? next : f;
    }
    return f;
}

inline void store_column(double* to, const Vector& v, int l) {
    to[0] = v.x[l];
    to[1] = v.y[l];
    to[2] = v.z[l];
}
inline void load_column(const double* from, Vector& v, int l) {
    v.x[l] = from[0];
    v.y[l] = from[1];
    v.z[l] = from[2];
}

inline void replace_singular(SingularRotation singular, Mask failed, const Matrix& f, Matrix& r) {
    for (int l = 0; l < width; ++l) {
        if (failed[l] != 0) {
            double from[9];
            double to[9];
            store_column(from, f.x, l);
            store_column(from + 3, f.y, l);
            store_column(from + 6, f.z, l);
            singular(from, to);
            load_column(to, r.x, l);
            load_column(to + 3, r.y, l);
            load_column(to + 6, r.z, l);
        }
    }
}

inline Matrix rotation(const Matrix& f, SingularRotation singular) {
    const Lanes c00 = dot(f.x, f.x), c11 = dot(f.y, f.y), c22 = dot(f.z, f.z);
    const Lanes c01 = dot(f.x, f.y), c02 = dot(f.x, f.z), c12 = dot(f.y, f.z);
    const Matrix q{cross(f.y, f.z), cross(f.z, f.x), cross(f.x, f.y)};
    const Lanes i1 = c00 + c11 + c22;
    // as the sum of squared minors: the difference I^2 - C:C cancels for flat elements
    const Lanes e2 = dot(q.x, q.x) + dot(q.y, q.y) + dot(q.z, q.z);
    const Lanes j = dot(f.x, q.x);
    const Lanes t = trace_of_stretch(i1, e2, j);
    const Lanes sigma = 0.5 * (t * t) - 0.5 * i1;
    const Lanes d = sigma * t - j;
    const Mask failed = ~(d > 0.5e-6 * (i1 * root(i1)));
    const Lanes inverse = 1.0 / (failed ? all(1.0) : d);
    const Lanes a = (sigma + i1) * inverse;
    const Lanes tq = t * inverse;
    const Lanes m01 = -(inverse * c01), m02 = -(inverse * c02), m12 = -(inverse * c12);
    const auto column = [&](Lanes x, Lanes y, Lanes z, const Vector& minor) {
        const Vector p = f * Vector{x, y, z};
        return Vector{p.x + tq * minor.x, p.y + tq * minor.y, p.z + tq * minor.z};
    };
    Matrix r{column(a - inverse * c00, m01, m02, q.x), column(m01, a - inverse * c11, m12, q.y),
             column(m02, m12, a - inverse * c22, q.z)};
    if (any(failed)) {
        replace_singular(singular, failed, f, r);
    }
    return r;
}

// --- twist stiffness -------------------------------------------------------------------------------------------------

/// One Jacobi rotation of the symmetric a (diagonal p, q; off-diagonal pq; the two others rp, rq) and of the vectors.
inline void annihilate(Lanes& p, Lanes& q, Lanes& pq, Lanes& rp, Lanes& rq, Vector& vp, Vector& vq) {
    const Mask done = pq == 0.0;
    const Lanes theta = (q - p) / (done ? all(1.0) : 2.0 * pq);
    const Lanes size = 1.0 / (absolute(theta) + root(theta * theta + 1.0));
    const Lanes t = done ? all(0.0) : (theta < 0.0 ? -size : size);
    const Lanes c = 1.0 / root(t * t + 1.0);
    const Lanes s = t * c;
    p -= t * pq;
    q += t * pq;
    pq = all(0.0);
    const Lanes old = rp;
    rp = c * old - s * rq;
    rq = s * old + c * rq;
    const Vector from = vp;
    vp = {c * from.x - s * vq.x, c * from.y - s * vq.y, c * from.z - s * vq.z};
    vq = {s * from.x + c * vq.x, s * from.y + c * vq.y, s * from.z + c * vq.z};
}

inline void add_mode(Symmetric& h, const Vector& v, Lanes value) {
    h.xx += value * (v.x * v.x);
    h.yy += value * (v.y * v.y);
    h.zz += value * (v.z * v.z);
    h.xy += value * (v.x * v.y);
    h.xz += value * (v.x * v.z);
    h.yz += value * (v.y * v.z);
}

/// H: max(c / g_i, least) about each principal axis of g.
inline Symmetric twist(Symmetric g, Lanes c, Lanes least) {
    const Lanes zero = all(0.0), one = all(1.0);
    Vector x{one, zero, zero}, y{zero, one, zero}, z{zero, zero, one};
    for (int sweep = 0; sweep < 6; ++sweep) {
        annihilate(g.xx, g.yy, g.xy, g.xz, g.yz, x, y);
        annihilate(g.xx, g.zz, g.xz, g.xy, g.yz, x, z);
        annihilate(g.yy, g.zz, g.yz, g.xy, g.xz, y, z);
    }
    const Lanes floor = 1e-6 * larger(larger(absolute(g.xx), absolute(g.yy)), absolute(g.zz)) + 1e-300;
    Symmetric h{zero, zero, zero, zero, zero, zero};
    add_mode(h, x, larger(c / larger(g.xx, floor), least));
    add_mode(h, y, larger(c / larger(g.yy, floor), least));
    add_mode(h, z, larger(c / larger(g.zz, floor), least));
    return h;
}

/// tr(S) I - R S R', from F and R: R S R' = F R'.
inline Symmetric turned_stretch(const Matrix& f, const Matrix& r, Lanes trace) {
    const auto entry = [&](Lanes Vector::*i, Lanes Vector::*k) {
        const Lanes ik = f.x.*i * r.x.*k + f.y.*i * r.y.*k + f.z.*i * r.z.*k;
        const Lanes ki = f.x.*k * r.x.*i + f.y.*k * r.y.*i + f.z.*k * r.z.*i;
        return 0.5 * (ik + ki);
    };
    return {trace - entry(&Vector::x, &Vector::x), trace - entry(&Vector::y, &Vector::y),
            trace - entry(&Vector::z, &Vector::z), -entry(&Vector::x, &Vector::y),
            -entry(&Vector::x, &Vector::z),        -entry(&Vector::y, &Vector::z)};
}

// --- elements --------------------------------------------------------------------------------------------------------

struct Element {
    Matrix f;
    Matrix r;
    Lanes twice_mu, lambda, trace;
};

template <int N>
inline void deformation(const Group& group, int lane, const double* position, SingularRotation singular, Element& e) {
    const int nodes = N > 0 ? N : group.nodes;
    const double* const data = group.data + lane;
    const int* const rows = group.index + lane;
    const Vector origin = gather(position, rows);
    const Vector zero{all(0.0), all(0.0), all(0.0)};
    e.f = {zero, zero, zero};
    for (int a = 1; a < nodes; ++a) {
        // differences first: positions far from the origin lose no digits
        const Vector d = gather(position, rows + lanes * a) - origin;
        const double* const b = data + lanes * (2 + 3 * a);
        const Lanes bx = load(b), by = load(b + lanes), bz = load(b + 2 * lanes);
        e.f.x = {e.f.x.x + d.x * bx, e.f.x.y + d.y * bx, e.f.x.z + d.z * bx};
        e.f.y = {e.f.y.x + d.x * by, e.f.y.y + d.y * by, e.f.y.z + d.z * by};
        e.f.z = {e.f.z.x + d.x * bz, e.f.z.y + d.y * bz, e.f.z.z + d.z * bz};
    }
    e.r = rotation(e.f, singular);
    e.trace = dot(e.f.x, e.r.x) + dot(e.f.y, e.r.y) + dot(e.f.z, e.r.z);
    e.twice_mu = load(data);
    e.lambda = load(data + lanes);
}

/// Columns of lambda ga gb' + 2 mu (ga . gb) I - [ga]x hb, hb = H [gb]x, scaled.
inline void put_block(Writer& out, const Vector& ga, const Vector& lgb, const Vector& mgb, const Matrix& hb) {
    const Lanes diagonal = dot(ga, mgb);
    const Vector x = cross(ga, hb.x), y = cross(ga, hb.y), z = cross(ga, hb.z);
    out.put(Vector{ga.x * lgb.x + diagonal - x.x, ga.y * lgb.x - x.y, ga.z * lgb.x - x.z});
    out.put(Vector{ga.x * lgb.y - y.x, ga.y * lgb.y + diagonal - y.y, ga.z * lgb.y - y.z});
    out.put(Vector{ga.x * lgb.z - z.x, ga.y * lgb.z - z.y, ga.z * lgb.z + diagonal - z.z});
}

/// Columns of lambda ga gb' + mu (ga . gb) I + mu gb ga', scaled.
inline void put_warped_block(Writer& out, const Vector& ga, const Vector& lgb, const Vector& mgb) {
    const Lanes diagonal = dot(ga, mgb);
    out.put(Vector{ga.x * lgb.x + mgb.x * ga.x + diagonal, ga.y * lgb.x + mgb.y * ga.x, ga.z * lgb.x + mgb.z * ga.x});
    out.put(Vector{ga.x * lgb.y + mgb.x * ga.y, ga.y * lgb.y + mgb.y * ga.y + diagonal, ga.z * lgb.y + mgb.z * ga.y});
    out.put(Vector{ga.x * lgb.z + mgb.x * ga.z, ga.y * lgb.z + mgb.y * ga.z, ga.z * lgb.z + mgb.z * ga.z + diagonal});
}

inline Symmetric twist_of(const Element& e, Mode mode) {
    const Lanes c = e.lambda * (e.trace - 3.0) - e.twice_mu;
    const Lanes least = mode == Mode::projected ? -0.5 * e.twice_mu : all(-1e300);
    return twist(turned_stretch(e.f, e.r, e.trace), c, least);
}

/// Columns of H [b]x: H times the cross products of b with the axes, from the right.
inline Matrix twisted(const Symmetric& h, const Vector& b) {
    const Lanes zero = all(0.0);
    return {h * Vector{zero, b.z, -b.y}, h * Vector{-b.z, zero, b.x}, h * Vector{b.y, -b.x, zero}};
}

template <int N>
inline void put_stiffness(const Element& e, const Vector* g, int nodes, Mode mode, double scale, Writer& out) {
    const Lanes lambda = e.lambda * scale;
    if (mode == Mode::warped) {
        const Lanes mu = 0.5 * (e.twice_mu * scale);
        for (int b = 0; b < nodes; ++b) {
            const Vector lgb = g[b] * lambda;
            const Vector mgb = g[b] * mu;
            for (int a = 0; a <= b; ++a) {
                put_warped_block(out, g[a], lgb, mgb);
            }
        }
        return;
    }
    const Symmetric h = twist_of(e, mode);
    for (int b = 0; b < nodes; ++b) {
        const Vector lgb = g[b] * lambda;
        const Vector mgb = g[b] * (e.twice_mu * scale);
        const Matrix hb = twisted(h, g[b] * all(scale));
        for (int a = 0; a <= b; ++a) {
            put_block(out, g[a], lgb, mgb, hb);
        }
    }
}

template <int N>
void compute(const Task& task, const Group& group, int lane, int length) {
    const int nodes = N > 0 ? N : group.nodes;
    Element e;
    deformation<N>(group, lane, task.position, task.singular, e);
    const double* const data = group.data + lane;
    Vector g[N > 0 ? N : most_nodes];
    Writer out(task.buffer + static_cast<long>(length) * lane, length);
    // -P R' g with g = R b: the force on a node is -V P b
    const Lanes pressure = e.lambda * (e.trace - 3.0) - e.twice_mu;
    for (int a = 0; a < nodes; ++a) {
        const double* const from = data + lanes * (2 + 3 * a);
        const Vector b{load(from), load(from + lanes), load(from + 2 * lanes)};
        g[a] = e.r * b;
        const Vector fb = e.f * b;
        out.put(Vector{-(e.twice_mu * fb.x + pressure * g[a].x), -(e.twice_mu * fb.y + pressure * g[a].y),
                       -(e.twice_mu * fb.z + pressure * g[a].z)});
    }
    if (task.mode != Mode::forces) {
        put_stiffness<N>(e, g, nodes, task.mode, task.scale, out);
    }
    out.finish();
}

template <int N>
inline void scatter(const Task& task, const Group& group, int length) {
    const int nodes = N > 0 ? N : group.nodes;
    const int pairs = task.mode == Mode::forces ? 0 : nodes * (nodes + 1) / 2;
    for (int l = 0; l < lanes; ++l) {
        add_to_rows(task.buffer + static_cast<long>(length) * l, group.index + l, nodes, pairs, task.force,
                    task.stiffness);
    }
}

template <int N>
inline void run(const Task& task, const Group& group) {
    const int length = buffer_length(N > 0 ? N : group.nodes);
    for (int lane = 0; lane < lanes; lane += width) {
        compute<N>(task, group, lane, length);
    }
    scatter<N>(task, group, length);
}

void assemble(const Task& task) {
    for (int k = 0; k < task.count; ++k) {
        if (task.groups[k].nodes == 4) {
            run<4>(task, task.groups[k]);
        } else {
            run<0>(task, task.groups[k]);
        }
    }
}
