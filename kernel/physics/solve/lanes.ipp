// SPDX-License-Identifier: GPL-3.0-or-later
// RHEXIS_WIDTH doubles at a time, vectors of them, and how results get from lanes to rows. Shared by the kernels of
// elements; included once per kernel and instruction set, in their namespaces.

constexpr int width = RHEXIS_WIDTH;
typedef double Lanes __attribute__((vector_size(8 * width)));
typedef long long Mask __attribute__((vector_size(8 * width)));

inline Lanes load(const double* from) {
    Lanes result;
    __builtin_memcpy(&result, from, sizeof result);
    return result;
}
inline void store(double* to, Lanes value) { __builtin_memcpy(to, &value, sizeof value); }
inline Lanes all(double value) { return Lanes{} + value; }
inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
inline Lanes absolute(Lanes a) { return a < 0.0 ? -a : a; }

#if RHEXIS_WIDTH == 8
inline Lanes root(Lanes a) { return reinterpret_cast<Lanes>(_mm512_sqrt_pd(reinterpret_cast<__m512d>(a))); }
inline bool any(Mask m) {
    return _mm512_test_epi64_mask(reinterpret_cast<__m512i>(m), reinterpret_cast<__m512i>(m)) != 0;
}
#elif RHEXIS_WIDTH == 4
inline Lanes root(Lanes a) { return reinterpret_cast<Lanes>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a))); }
inline bool any(Mask m) { return _mm256_movemask_pd(reinterpret_cast<__m256d>(m)) != 0; }
#else
inline Lanes root(Lanes a) { return reinterpret_cast<Lanes>(_mm_sqrt_pd(reinterpret_cast<__m128d>(a))); }
inline bool any(Mask m) { return _mm_movemask_pd(reinterpret_cast<__m128d>(m)) != 0; }
#endif

struct Vector {
    Lanes x, y, z;
};
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(const Vector& a, Lanes s) { return {a.x * s, a.y * s, a.z * s}; }
inline Lanes dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Vector gather(const double* position, const int* rows) {
    Vector result;
    for (int l = 0; l < width; ++l) {
        const double* const from = position + 3 * static_cast<long>(rows[l]);
        result.x[l] = from[0];
        result.y[l] = from[1];
        result.z[l] = from[2];
    }
    return result;
}

/// Turns `width` registers so that register l holds what was in lane l.
inline void transpose(Lanes* v) {
#if RHEXIS_WIDTH == 8
    for (int i = 0; i < 8; i += 2) {
        const Lanes low = __builtin_shufflevector(v[i], v[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        v[i + 1] = __builtin_shufflevector(v[i], v[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
        v[i] = low;
    }
    for (int i = 0; i < 8; i += 4) {
        for (int k = i; k < i + 2; ++k) {
            const Lanes low = __builtin_shufflevector(v[k], v[k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
            v[k + 2] = __builtin_shufflevector(v[k], v[k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
            v[k] = low;
        }
    }
    for (int k = 0; k < 4; ++k) {
        const Lanes low = __builtin_shufflevector(v[k], v[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        v[k + 4] = __builtin_shufflevector(v[k], v[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
        v[k] = low;
    }
#elif RHEXIS_WIDTH == 4
    for (int i = 0; i < 4; i += 2) {
        const Lanes low = __builtin_shufflevector(v[i], v[i + 1], 0, 4, 2, 6);
        v[i + 1] = __builtin_shufflevector(v[i], v[i + 1], 1, 5, 3, 7);
        v[i] = low;
    }
    for (int k = 0; k < 2; ++k) {
        const Lanes low = __builtin_shufflevector(v[k], v[k + 2], 0, 1, 4, 5);
        v[k + 2] = __builtin_shufflevector(v[k], v[k + 2], 2, 3, 6, 7);
        v[k] = low;
    }
#else
    const Lanes low = __builtin_shufflevector(v[0], v[1], 0, 2);
    v[1] = __builtin_shufflevector(v[0], v[1], 1, 3);
    v[0] = low;
#endif
}

/// Collects numbers of all lanes and writes each lane's in a row.
class Writer {
public:
    Writer(double* start, int row_length) : to(start), length(row_length) {}

    void put(Lanes value) {
        waiting[filled++] = value;
        if (filled == width) {
            flush();
        }
    }
    void put(const Vector& v) {
        put(v.x);
        put(v.y);
        put(v.z);
    }
    void flush() {
        transpose(waiting);
        for (int l = 0; l < width; ++l) {
            store(to + static_cast<long>(length) * l, waiting[l]);
        }
        to += width;
        filled = 0;
    }
    void finish() {
        if (filled > 0) {
            for (int k = filled; k < width; ++k) {
                waiting[k] = all(0.0);
            }
            flush();
        }
    }

private:
    double* to;
    int length;
    int filled = 0;
    Lanes waiting[width];
};

typedef double Wide __attribute__((vector_size(64)));
inline Wide load_wide(const double* from) {
    Wide result;
    __builtin_memcpy(&result, from, sizeof result);
    return result;
}

/// Adds what one lane has written, three numbers per node and nine per pair of nodes, to where its index says: one
/// element after the other, so that sums do not depend on the width.
inline void add_to_rows(const double* from, const int* index, int nodes, int pairs, double* force, double* stiffness) {
    for (int a = 0; a < nodes; ++a, from += 3, index += lanes) {
        double* const to = force + 3 * static_cast<long>(*index);
        to[0] += from[0];
        to[1] += from[1];
        to[2] += from[2];
    }
    for (int p = 0; p < pairs; ++p, from += 9, index += lanes) {
        double* const to = stiffness + *index;
        const Wide sum = load_wide(to) + load_wide(from);
        to[8] += from[8];
        __builtin_memcpy(to, &sum, sizeof sum);
    }
}
