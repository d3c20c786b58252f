// SPDX-License-Identifier: GPL-3.0-or-later
// Body of the shell triangle for a type N of numbers, double or lanes of them; included in a namespace of its own for
// each instruction set, with root(N) and larger(N, N) for this N declared before. Formulas: energy/shell_triangle.hpp.
// Nothing branches on numbers, so lanes do not see each other.

template <typename N>
struct Triple {
    N v[3];
    N& operator[](int i) { return v[i]; }
    const N& operator[](int i) const { return v[i]; }
};
template <typename N>
inline Triple<N> operator+(const Triple<N>& a, const Triple<N>& b) {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
template <typename N>
inline Triple<N> operator-(const Triple<N>& a, const Triple<N>& b) {
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
template <typename N>
inline Triple<N> operator*(const Triple<N>& a, N s) {
    return {{a[0] * s, a[1] * s, a[2] * s}};
}
template <typename N>
inline N dot(const Triple<N>& a, const Triple<N>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <typename N>
inline Triple<N> cross(const Triple<N>& a, const Triple<N>& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// m[i][j]: row i, column j.
template <typename N>
struct Square {
    N m[3][3];
};
template <typename N>
inline Square<N> operator*(const Square<N>& a, const Square<N>& b) {
    Square<N> result;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            result.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] + a.m[i][2] * b.m[2][j];
        }
    }
    return result;
}
/// a' b
template <typename N>
inline Square<N> transposed_times(const Square<N>& a, const Square<N>& b) {
    Square<N> result;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            result.m[i][j] = a.m[0][i] * b.m[0][j] + a.m[1][i] * b.m[1][j] + a.m[2][i] * b.m[2][j];
        }
    }
    return result;
}
/// a b'
template <typename N>
inline Square<N> times_transposed(const Square<N>& a, const Square<N>& b) {
    Square<N> result;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            result.m[i][j] = a.m[i][0] * b.m[j][0] + a.m[i][1] * b.m[j][1] + a.m[i][2] * b.m[j][2];
        }
    }
    return result;
}
template <typename N>
inline Square<N> operator+(const Square<N>& a, const Square<N>& b) {
    Square<N> result;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            result.m[i][j] = a.m[i][j] + b.m[i][j];
        }
    }
    return result;
}
template <typename N>
inline Square<N> cross_square(const Triple<N>& v) {
    const N zero = v[0] - v[0];
    return {{{zero, -v[2], v[1]}, {v[2], zero, -v[0]}, {-v[1], v[0], zero}}};
}
template <typename N>
inline Triple<N> times(const Square<N>& a, const Triple<N>& v) {
    return {{a.m[0][0] * v[0] + a.m[0][1] * v[1] + a.m[0][2] * v[2],
             a.m[1][0] * v[0] + a.m[1][1] * v[1] + a.m[1][2] * v[2],
             a.m[2][0] * v[0] + a.m[2][1] * v[1] + a.m[2][2] * v[2]}};
}

/// Symmetric, 9 by 9: the lower triangle by rows.
constexpr int packed_length = 45;
constexpr int packed(int i, int j) { return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i; }

/// At rest.
template <typename N>
struct Rest {
    N corner[3][2];
    N gradient[3][2];
    Square<N> frame;
    N membrane[packed_length];
    N bending[packed_length];
    N tension[3];     ///< entries 11, 12, 33 of an isotropic stiffness
    N natural[3][5];  ///< deformation at which it bears no stress: u, then theta of each corner
};
constexpr int natural_length = 15;
constexpr int rest_length = 6 + 6 + 9 + 2 * packed_length + 3 + natural_length;

/// Where the corners are; every array by corners.
template <typename N>
struct Now {
    Triple<N> position[3];
    Square<N> rotation[3];
};

/// What forces and tangent share.
template <typename N>
struct Deformed {
    Square<N> frame;              ///< E
    N trace;                      ///< of the stretch in the plane
    N place[3][2];                ///< corners in E, about their middle
    N gradient[3][2];             ///< of the shape functions there
    N moved[3][2];                ///< u
    Triple<N> turned[3];          ///< theta
    Triple<N> force[3];           ///< K d
    Triple<N> moment[3];          ///< K d
    Triple<N> lifted[3];          ///< H' moment
    Triple<N> unbalanced;         ///< S' (force, lifted)
    Triple<N> gradient_force[3];  ///< of the energy by movement, in E
    N energy;
};

template <typename N>
inline void find_frame(const Rest<N>& rest, const Now<N>& now, Deformed<N>& d) {
    const Triple<N> zero = now.position[0] - now.position[0];
    Triple<N> f1 = zero;
    Triple<N> f2 = zero;
    for (int a = 0; a < 3; ++a) {
        f1 = f1 + now.position[a] * rest.gradient[a][0];
        f2 = f2 + now.position[a] * rest.gradient[a][1];
    }
    const Triple<N> area = cross(f1, f2);
    const N tiny = zero[0] + 1e-60;
    const Triple<N> normal = area * (1.0 / root(larger(dot(area, area), tiny)));
    const Triple<N> first = f1 + cross(f2, normal);  // polar decomposition in the plane: F + cof F
    const Triple<N> e1 = first * (1.0 / root(larger(dot(first, first), tiny)));
    const Triple<N> e2 = cross(normal, e1);
    for (int i = 0; i < 3; ++i) {
        d.frame.m[i][0] = e1[i];
        d.frame.m[i][1] = e2[i];
        d.frame.m[i][2] = normal[i];
    }
    d.trace = dot(e1, f1) + dot(e2, f2);
    const Triple<N> middle = (now.position[0] + now.position[1] + now.position[2]) * (zero[0] + 1.0 / 3.0);
    for (int a = 0; a < 3; ++a) {
        const Triple<N> arm = now.position[a] - middle;
        d.place[a][0] = dot(e1, arm);
        d.place[a][1] = dot(e2, arm);
        d.moved[a][0] = d.place[a][0] - rest.corner[a][0];
        d.moved[a][1] = d.place[a][1] - rest.corner[a][1];
    }
}

template <typename N>
inline void find_gradients(Deformed<N>& d) {
    const N twice = (d.place[1][0] - d.place[0][0]) * (d.place[2][1] - d.place[0][1]) -
                    (d.place[1][1] - d.place[0][1]) * (d.place[2][0] - d.place[0][0]);
    const N scale = twice / larger(twice * twice, twice - twice + 1e-60);  // of either sign: corners in any order
    for (int a = 0; a < 3; ++a) {
        const int j = (a + 1) % 3;
        const int k = (a + 2) % 3;
        d.gradient[a][0] = (d.place[j][1] - d.place[k][1]) * scale;
        d.gradient[a][1] = (d.place[k][0] - d.place[j][0]) * scale;
    }
}

/// The stereographic vector of a rotation of less than half a turn.
template <typename N>
inline Triple<N> stereographic(const Square<N>& r) {
    const N zero = r.m[0][0] - r.m[0][0];
    const N s = root(larger(1.0 + (r.m[0][0] + r.m[1][1] + r.m[2][2]), zero + 1e-12));  // 2 cos(angle / 2)
    const N scale = 4.0 / (s * (2.0 + s));  // the axial vector is 2 sin(angle / 2) s axis
    return {{(r.m[2][1] - r.m[1][2]) * scale, (r.m[0][2] - r.m[2][0]) * scale, (r.m[1][0] - r.m[0][1]) * scale}};
}

template <typename N>
inline void find_forces(const Rest<N>& rest, Deformed<N>& d) {
    const N zero = d.trace - d.trace;
    N in_plane[9];
    N out[9];
    for (int a = 0; a < 3; ++a) {
        in_plane[3 * a] = d.moved[a][0] - rest.natural[a][0];
        in_plane[3 * a + 1] = d.moved[a][1] - rest.natural[a][1];
        in_plane[3 * a + 2] = d.turned[a][2] - rest.natural[a][4];
        out[3 * a] = zero;
        out[3 * a + 1] = d.turned[a][0] - rest.natural[a][2];
        out[3 * a + 2] = d.turned[a][1] - rest.natural[a][3];
    }
    d.energy = zero;
    for (int a = 0; a < 3; ++a) {
        N stretch[3];
        N bend[3];
        for (int i = 0; i < 3; ++i) {
            stretch[i] = zero;
            bend[i] = zero;
            for (int j = 0; j < 9; ++j) {
                stretch[i] = stretch[i] + rest.membrane[packed(3 * a + i, j)] * in_plane[j];
                if (j % 3 != 0) {  // corners stay in the triangle's plane
                    bend[i] = bend[i] + rest.bending[packed(3 * a + i, j)] * out[j];
                }
            }
            d.energy = d.energy + 0.5 * (stretch[i] * in_plane[3 * a + i] + bend[i] * out[3 * a + i]);
        }
        d.force[a] = {{stretch[0], stretch[1], bend[0]}};
        d.moment[a] = {{bend[1], bend[2], stretch[2]}};
    }
}

/// H' m
template <typename N>
inline Triple<N> lift(const Triple<N>& theta, const Triple<N>& m) {
    const N share = 1.0 - 0.0625 * dot(theta, theta);
    return m * share + cross(theta, m) * (share - share + 0.5) + theta * (0.125 * dot(theta, m));
}

/// What follows from force and moment.
template <typename N>
inline void find_resultants(const Rest<N>& rest, Deformed<N>& d) {
    d.unbalanced = d.force[0] - d.force[0];
    for (int a = 0; a < 3; ++a) {
        d.lifted[a] = lift(d.turned[a], d.moment[a]);
        const Triple<N> arm{{d.place[a][0], d.place[a][1], d.trace - d.trace}};
        d.unbalanced = d.unbalanced + cross(arm, d.force[a]) + d.lifted[a];
    }
    const N twist = d.unbalanced[2] / d.trace;
    for (int a = 0; a < 3; ++a) {
        d.gradient_force[a] = {
            {d.force[a][0] + rest.gradient[a][1] * twist, d.force[a][1] - rest.gradient[a][0] * twist,
             d.force[a][2] - (d.gradient[a][1] * d.unbalanced[0] - d.gradient[a][0] * d.unbalanced[1])}};
    }
}

/// Frame, place and deformation alone.
template <typename N>
inline void find_deformation(const Rest<N>& rest, const Now<N>& now, Deformed<N>& d) {
    find_frame(rest, now, d);
    for (int a = 0; a < 3; ++a) {
        d.turned[a] = stereographic(transposed_times(d.frame, now.rotation[a] * rest.frame));
    }
}

template <typename N>
inline void deform(const Rest<N>& rest, const Now<N>& now, Deformed<N>& d) {
    find_deformation(rest, now, d);
    find_gradients(d);
    find_forces(rest, d);
    find_resultants(rest, d);
}

// --- tangent ---------------------------------------------------------------------------------------------------------

/// By pairs of (movement, spin) of the corners: block (i, j) with i = 2 corner + 0 or 1, i <= j.
constexpr int blocks = 21;
constexpr int block_of(int i, int j) { return 6 * i - i * (i - 1) / 2 + (j - i); }

template <typename N>
inline Square<N> spin_rate(const Triple<N>& theta) {
    Square<N> h;
    const N share = 1.0 - 0.0625 * dot(theta, theta);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            h.m[i][j] = 0.125 * (theta[i] * theta[j]);
        }
        h.m[i][i] = h.m[i][i] + share;
    }
    h.m[0][1] = h.m[0][1] + 0.5 * theta[2];
    h.m[0][2] = h.m[0][2] - 0.5 * theta[1];
    h.m[1][0] = h.m[1][0] - 0.5 * theta[2];
    h.m[1][2] = h.m[1][2] + 0.5 * theta[0];
    h.m[2][0] = h.m[2][0] + 0.5 * theta[1];
    h.m[2][1] = h.m[2][1] - 0.5 * theta[0];
    return h;
}

/// Forces and moments (K d) to first order after a step of the corners, movement and spin in space; overwrites those of
/// d with them.
template <typename N>
inline void predict(const Rest<N>& rest, const Triple<N> (&movement)[3], const Triple<N> (&spin)[3], Deformed<N>& d) {
    const N zero = d.trace - d.trace;
    Triple<N> whole{{zero, zero, zero}};  // spin of the frame
    Triple<N> step[3];
    for (int a = 0; a < 3; ++a) {
        for (int i = 0; i < 3; ++i) {
            step[a][i] =
                d.frame.m[0][i] * movement[a][0] + d.frame.m[1][i] * movement[a][1] + d.frame.m[2][i] * movement[a][2];
        }
        whole[0] = whole[0] + d.gradient[a][1] * step[a][2];
        whole[1] = whole[1] - d.gradient[a][0] * step[a][2];
        whole[2] = whole[2] + (rest.gradient[a][0] * step[a][1] - rest.gradient[a][1] * step[a][0]) / d.trace;
    }
    for (int a = 0; a < 3; ++a) {
        d.moved[a][0] = d.moved[a][0] + (step[a][0] + whole[2] * d.place[a][1]);
        d.moved[a][1] = d.moved[a][1] + (step[a][1] - whole[2] * d.place[a][0]);
        Triple<N> turn;
        for (int i = 0; i < 3; ++i) {
            turn[i] = d.frame.m[0][i] * spin[a][0] + d.frame.m[1][i] * spin[a][1] + d.frame.m[2][i] * spin[a][2];
        }
        d.turned[a] = d.turned[a] + times(spin_rate(d.turned[a]), turn - whole);
    }
    find_forces(rest, d);
}

/// Symmetric part of d(H' m)/dtheta H.
template <typename N>
inline Square<N> moment_rate(const Triple<N>& theta, const Triple<N>& m, const Square<N>& h) {
    Square<N> rate;
    const N along = 0.125 * dot(theta, m);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            rate.m[i][j] = 0.125 * (theta[i] * m[j] - m[i] * theta[j]);
        }
        rate.m[i][i] = rate.m[i][i] + along;
    }
    rate.m[0][1] = rate.m[0][1] + 0.5 * m[2];
    rate.m[0][2] = rate.m[0][2] - 0.5 * m[1];
    rate.m[1][0] = rate.m[1][0] - 0.5 * m[2];
    rate.m[1][2] = rate.m[1][2] + 0.5 * m[0];
    rate.m[2][0] = rate.m[2][0] + 0.5 * m[1];
    rate.m[2][1] = rate.m[2][1] - 0.5 * m[0];
    const Square<N> whole = rate * h;
    Square<N> result;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            result.m[i][j] = 0.5 * (whole.m[i][j] + whole.m[j][i]);
        }
    }
    return result;
}

/// K for (movement, movement), (movement, spin), (spin, spin) of two corners, before H.
template <typename N>
inline Square<N> rest_block(const Rest<N>& rest, int a, int b, int kind) {
    const N zero = rest.tension[0] - rest.tension[0];
    const auto m = [&](int i, int j) { return rest.membrane[packed(3 * a + i, 3 * b + j)]; };
    const auto k = [&](int i, int j) { return rest.bending[packed(3 * a + i, 3 * b + j)]; };
    if (kind == 0) {
        return {{{m(0, 0), m(0, 1), zero}, {m(1, 0), m(1, 1), zero}, {zero, zero, k(0, 0)}}};
    }
    if (kind == 1) {
        return {{{zero, zero, m(0, 2)}, {zero, zero, m(1, 2)}, {k(0, 1), k(0, 2), zero}}};
    }
    return {{{k(1, 1), k(1, 2), zero}, {k(2, 1), k(2, 2), zero}, {zero, zero, m(2, 2)}}};
}

/// First M = H' K H + L in the frame, in the end the tangent in space.
template <typename N>
struct Tangent {
    Square<N> block[blocks];
    Square<N> cross_block[3][3];  ///< (movement a, spin b) for all pairs
};

template <typename N, bool consistent>
inline void material_blocks(const Rest<N>& rest, const Deformed<N>& d, Tangent<N>& t) {
    Square<N> h[3];
    for (int a = 0; a < 3; ++a) {
        h[a] = spin_rate(d.turned[a]);
    }
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
            t.cross_block[a][b] = rest_block(rest, a, b, 1) * h[b];
        }
    }
    for (int a = 0; a < 3; ++a) {
        for (int b = a; b < 3; ++b) {
            t.block[block_of(2 * a, 2 * b)] = rest_block(rest, a, b, 0);
            t.block[block_of(2 * a, 2 * b + 1)] = t.cross_block[a][b];
            Square<N> spins = transposed_times(h[a], rest_block(rest, a, b, 2) * h[b]);
            if (a == b) {
                if constexpr (consistent) {
                    spins = spins + moment_rate(d.turned[a], d.moment[a], h[a]);
                }
            } else {
                Square<N>& lower = t.block[block_of(2 * a + 1, 2 * b)];
                for (int i = 0; i < 3; ++i) {
                    for (int j = 0; j < 3; ++j) {
                        lower.m[i][j] = t.cross_block[b][a].m[j][i];
                    }
                }
            }
            t.block[block_of(2 * a + 1, 2 * b + 1)] = spins;
        }
    }
}

/// Block (i, j) of M for any i, j: column c of row r.
template <typename N>
inline N entry(const Tangent<N>& t, int i, int j, int r, int c) {
    return i <= j ? t.block[block_of(i, j)].m[r][c] : t.block[block_of(j, i)].m[c][r];
}

/// y += m [p]x' for p in the plane: m times the movement p x w.
template <typename N>
inline void add_arm(const Tangent<N>& t, int i, int b, const N* p, Square<N>& y) {
    for (int r = 0; r < 3; ++r) {
        const N m0 = entry(t, i, 2 * b, r, 0);
        const N m1 = entry(t, i, 2 * b, r, 1);
        const N m2 = entry(t, i, 2 * b, r, 2);
        y.m[r][0] = y.m[r][0] + m2 * p[1];
        y.m[r][1] = y.m[r][1] - m2 * p[0];
        y.m[r][2] = y.m[r][2] + (m1 * p[0] - m0 * p[1]);
        for (int c = 0; c < 3; ++c) {
            y.m[r][c] = y.m[r][c] + entry(t, i, 2 * b + 1, r, c);
        }
    }
}

/// [p]x y for p in the plane.
template <typename N>
inline Square<N> arm_times(const N* p, const Square<N>& y) {
    Square<N> result;
    for (int c = 0; c < 3; ++c) {
        result.m[0][c] = p[1] * y.m[2][c];
        result.m[1][c] = -(p[0] * y.m[2][c]);
        result.m[2][c] = p[0] * y.m[1][c] - p[1] * y.m[0][c];
    }
    return result;
}

/// M S, then Y of  P' M P - sym(F_nm G + G' F_n' P) = M - Y G - G' Y'.
template <typename N, bool consistent>
inline void projection(const Rest<N>& rest, const Deformed<N>& d, const Tangent<N>& t, Square<N> (&y)[6]) {
    const N zero = d.trace - d.trace;
    for (int i = 0; i < 6; ++i) {
        y[i] = cross_square(Triple<N>{{zero, zero, zero}});
        for (int b = 0; b < 3; ++b) {
            add_arm(t, i, b, d.place[b], y[i]);
        }
    }
    Square<N> whole = cross_square(Triple<N>{{zero, zero, zero}});
    for (int a = 0; a < 3; ++a) {
        whole = whole + arm_times(d.place[a], y[2 * a]) + y[2 * a + 1];
    }
    if constexpr (consistent) {
        const N half = zero + 0.5;
        for (int a = 0; a < 3; ++a) {
            const Square<N> moved = arm_times(d.place[a], cross_square(d.force[a] * half));
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) {
                    whole.m[i][j] = whole.m[i][j] + (moved.m[i][j] + moved.m[j][i]);
                }
            }
            y[2 * a] = y[2 * a] + cross_square((d.gradient_force[a] + d.force[a]) * half);
            y[2 * a + 1] = y[2 * a + 1] + cross_square(d.lifted[a] * half);
        }
    }
    for (int a = 0; a < 3; ++a) {  // y -= G' whole / 2
        const N g1 = 0.5 * d.gradient[a][1];
        const N g0 = 0.5 * d.gradient[a][0];
        const N r1 = 0.5 * (rest.gradient[a][1] / d.trace);
        const N r0 = 0.5 * (rest.gradient[a][0] / d.trace);
        for (int c = 0; c < 3; ++c) {
            y[2 * a].m[0][c] = y[2 * a].m[0][c] + r1 * whole.m[2][c];
            y[2 * a].m[1][c] = y[2 * a].m[1][c] - r0 * whole.m[2][c];
            y[2 * a].m[2][c] = y[2 * a].m[2][c] - (g1 * whole.m[0][c] - g0 * whole.m[1][c]);
        }
    }
}

/// M -= Y G + G' Y'.
template <typename N>
inline void subtract_spin(const Rest<N>& rest, const Deformed<N>& d, const Square<N> (&y)[6], Tangent<N>& t) {
    const N scale = 1.0 / d.trace;
    N g[3][4];  // G of a corner: entries (0, z), (1, z), (2, x), (2, y)
    for (int a = 0; a < 3; ++a) {
        g[a][0] = d.gradient[a][1];
        g[a][1] = -d.gradient[a][0];
        g[a][2] = -(rest.gradient[a][1] * scale);
        g[a][3] = rest.gradient[a][0] * scale;
    }
    for (int i = 0; i < 6; ++i) {
        for (int j = i; j < 6; ++j) {
            Square<N>& m = t.block[block_of(i, j)];
            if (j % 2 == 0) {  // y_i G_j
                const N* const own = g[j / 2];
                for (int r = 0; r < 3; ++r) {
                    m.m[r][0] = m.m[r][0] - y[i].m[r][2] * own[2];
                    m.m[r][1] = m.m[r][1] - y[i].m[r][2] * own[3];
                    m.m[r][2] = m.m[r][2] - (y[i].m[r][0] * own[0] + y[i].m[r][1] * own[1]);
                }
            }
            if (i % 2 == 0) {  // G_i' y_j'
                const N* const own = g[i / 2];
                for (int c = 0; c < 3; ++c) {
                    m.m[0][c] = m.m[0][c] - y[j].m[c][2] * own[2];
                    m.m[1][c] = m.m[1][c] - y[j].m[c][2] * own[3];
                    m.m[2][c] = m.m[2][c] - (y[j].m[c][0] * own[0] + y[j].m[c][1] * own[1]);
                }
            }
        }
    }
}

/// Symmetric part of -(dG') times the unbalanced moment, by movements.
template <typename N>
inline void add_frame_change(const Rest<N>& rest, const Deformed<N>& d, Tangent<N>& t) {
    const N scale = 1.0 / d.trace;
    const N twist = d.unbalanced[2] * scale * scale;
    const Triple<N>& tau = d.unbalanced;
    N c[3];
    N turn[3];
    for (int a = 0; a < 3; ++a) {
        c[a] = d.gradient[a][1] * tau[0] - d.gradient[a][0] * tau[1];
        turn[a] = (d.gradient[a][0] * tau[0] + d.gradient[a][1] * tau[1]) * scale;
    }
    for (int a = 0; a < 3; ++a) {
        for (int b = a; b < 3; ++b) {
            Square<N>& m = t.block[block_of(2 * a, 2 * b)];
            const N* const ga = rest.gradient[a];
            const N* const gb = rest.gradient[b];
            const N half_twist = 0.5 * twist;
            const N mixed = ga[0] * gb[0] - ga[1] * gb[1];
            // (-g_ay, g_ax) (g_b)' and the transpose of the same of (b, a)
            m.m[0][0] = m.m[0][0] - half_twist * (ga[1] * gb[0] + ga[0] * gb[1]);
            m.m[0][1] = m.m[0][1] + half_twist * mixed;
            m.m[1][0] = m.m[1][0] + half_twist * mixed;
            m.m[1][1] = m.m[1][1] + half_twist * (ga[0] * gb[1] + ga[1] * gb[0]);
            m.m[2][0] = m.m[2][0] + 0.5 * (c[b] * d.gradient[a][0] - turn[a] * gb[1]);
            m.m[2][1] = m.m[2][1] + 0.5 * (c[b] * d.gradient[a][1] + turn[a] * gb[0]);
            m.m[0][2] = m.m[0][2] + 0.5 * (c[a] * d.gradient[b][0] - turn[b] * ga[1]);
            m.m[1][2] = m.m[1][2] + 0.5 * (c[a] * d.gradient[b][1] + turn[b] * ga[0]);
        }
    }
}

/// The tensile part of the stress that the strain of the straight-sided triangle makes, acting on the normal.
template <typename N>
inline void add_tension(const Rest<N>& rest, const Deformed<N>& d, Tangent<N>& t) {
    const N zero = d.trace - d.trace;
    N e11 = zero;
    N e22 = zero;
    N shear = zero;
    N area = zero;
    for (int a = 0; a < 3; ++a) {
        const N u = d.moved[a][0] - rest.natural[a][0];
        const N v = d.moved[a][1] - rest.natural[a][1];
        e11 = e11 + rest.gradient[a][0] * u;
        e22 = e22 + rest.gradient[a][1] * v;
        shear = shear + (rest.gradient[a][1] * u + rest.gradient[a][0] * v);
    }
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3;
        area = area + 0.5 * (rest.corner[a][0] * rest.corner[b][1] - rest.corner[a][1] * rest.corner[b][0]);
    }
    const N s11 = rest.tension[0] * e11 + rest.tension[1] * e22;
    const N s22 = rest.tension[1] * e11 + rest.tension[0] * e22;
    const N s12 = rest.tension[2] * shear;
    area = root(area * area);
    const N mean = 0.5 * (s11 + s22);
    const N half = 0.5 * (s11 - s22);
    const N radius = root(half * half + s12 * s12);
    const N high = larger(mean + radius, zero);
    const N low = larger(mean - radius, zero);
    // high and low on the projectors of the principal directions: (high + low) / 2 1 + (high - low) / 2 (s - mean) /
    // radius
    const N middle = 0.5 * (high + low);
    const N slope = 0.5 * (high - low) / larger(radius, zero + 1e-60);
    const N t11 = area * (middle + slope * half);
    const N t22 = area * (middle - slope * half);
    const N t12 = area * (slope * s12);
    for (int a = 0; a < 3; ++a) {
        for (int b = a; b < 3; ++b) {
            const N* const ga = d.gradient[a];
            const N* const gb = d.gradient[b];
            N& out = t.block[block_of(2 * a, 2 * b)].m[2][2];
            out = out + (ga[0] * (t11 * gb[0] + t12 * gb[1]) + ga[1] * (t12 * gb[0] + t22 * gb[1]));
        }
    }
}

/// The tangent in space: block (i, j) as block_of says.
template <typename N, bool consistent>
inline void tangent(const Rest<N>& rest, const Deformed<N>& d, Tangent<N>& t) {
    material_blocks<N, consistent>(rest, d, t);
    Square<N> y[6];
    projection<N, consistent>(rest, d, t, y);
    subtract_spin(rest, d, y, t);
    if constexpr (consistent) {
        add_frame_change(rest, d, t);
    } else {
        add_tension(rest, d, t);
    }
    for (int k = 0; k < blocks; ++k) {
        t.block[k] = d.frame * times_transposed(t.block[k], d.frame);
    }
}
