// SPDX-License-Identifier: GPL-3.0-or-later
// Body of the linear kernel for RHEXIS_WIDTH floats at a time; included once per instruction set, in a namespace of its
// own. Tiles differ in size between instruction sets; the sums they form do not.

constexpr int width = RHEXIS_WIDTH;
constexpr int tile_rows = RHEXIS_TILE;  // registers of rows in a tile
typedef float Lanes __attribute__((vector_size(4 * width)));
typedef float Eight __attribute__((vector_size(32)));
typedef float Four __attribute__((vector_size(16)));
typedef float Two __attribute__((vector_size(8)));
typedef double Node __attribute__((vector_size(32)));

// Through memcpy: no alignment is assumed.
template <typename Register, typename Number>
inline Register load(const Number* from) {
    Register result;
    __builtin_memcpy(&result, from, sizeof result);
    return result;
}
template <typename Register, typename Number>
inline void store(Number* to, Register value) {
    __builtin_memcpy(to, &value, sizeof value);
}

inline int rounded(int rows) { return (rows + row_unit - 1) / row_unit * row_unit; }
inline int smaller(int a, int b) { return a < b ? a : b; }

// --- elimination -----------------------------------------------------------------------------------------------------

/// R registers of rows by C columns.
template <int R, int C>
struct Tile {
    Lanes sum[C][R];

    void clear() {
        for (int c = 0; c < C; ++c) {
            for (int r = 0; r < R; ++r) {
                sum[c][r] = Lanes{};
            }
        }
    }
    void take(const float* from, int leading) {
        for (int c = 0; c < C; ++c) {
            for (int r = 0; r < R; ++r) {
                sum[c][r] = load<Lanes>(from + std::ptrdiff_t{leading} * c + r * width);
            }
        }
    }
    void put(float* to, int leading) const {
        for (int c = 0; c < C; ++c) {
            for (int r = 0; r < R; ++r) {
                store(to + std::ptrdiff_t{leading} * c + r * width, sum[c][r]);
            }
        }
    }
    /// Less the products of `depth` columns of rows with those of factors.
    void subtract(const float* rows, int rows_leading, const float* factors, int factors_leading, int depth) {
        for (int k = 0; k < depth; ++k, rows += rows_leading, factors += factors_leading) {
            Lanes own[R];
            for (int r = 0; r < R; ++r) {
                own[r] = load<Lanes>(rows + r * width);
            }
            for (int c = 0; c < C; ++c) {
                const float factor = factors[c];
                for (int r = 0; r < R; ++r) {
                    sum[c][r] -= own[r] * factor;
                }
            }
        }
    }
    /// Solves with the triangle of C columns.
    void finish(const float (&factor)[C][C], const float (&inverse)[C]) {
        for (int c = 0; c < C; ++c) {
            for (int r = 0; r < R; ++r) {
                for (int k = 0; k < c; ++k) {
                    sum[c][r] -= sum[k][r] * factor[c][k];
                }
                sum[c][r] *= inverse[c];
            }
        }
    }
};

/// Cholesky of C columns of a triangle from column j on; false if a pivot is not positive.
template <int C>
inline bool factor_triangle(const float* corner, int leading, float (&factor)[C][C], float (&inverse)[C]) {
#pragma GCC unroll 6
    for (int c = 0; c < C; ++c) {
#pragma GCC unroll 6
        for (int r = c; r < C; ++r) {
            float sum = corner[std::ptrdiff_t{leading} * c + r];
#pragma GCC unroll 6
            for (int k = 0; k < c; ++k) {
                sum -= factor[r][k] * factor[c][k];
            }
            factor[r][c] = sum;
        }
        if (!(factor[c][c] > 1e-30F && factor[c][c] < 1e30F)) {
            return false;
        }
        const float pivot = __builtin_sqrtf(factor[c][c]);
        inverse[c] = 1.0F / pivot;
        factor[c][c] = pivot;
#pragma GCC unroll 6
        for (int r = c + 1; r < C; ++r) {
            factor[r][c] *= inverse[c];
        }
    }
    return true;
}

template <int R, int C>
inline void eliminate_tile(const Front& front, int j, int i, const float (&factor)[C][C], const float (&inverse)[C]) {
    Tile<R, C> tile;
    float* const own = front.below + std::ptrdiff_t{front.below_leading} * j + i;
    tile.take(own, front.below_leading);
    tile.subtract(front.below + i, front.below_leading, front.pivot + j, front.pivot_leading, j);
    tile.finish(factor, inverse);
    tile.put(own, front.below_leading);
}

/// C columns from j on, the columns before being done.
template <int C>
inline bool eliminate_columns(const Front& front, int j) {
    float* const corner = front.pivot + std::ptrdiff_t{front.pivot_leading} * j;
    const int start = j / width * width;
    if (j > 0) {
        for (int i = start; i < front.pivot_leading; i += width) {
            Tile<1, C> tile;
            tile.take(corner + i, front.pivot_leading);
            tile.subtract(front.pivot + i, front.pivot_leading, front.pivot + j, front.pivot_leading, j);
            tile.put(corner + i, front.pivot_leading);
        }
    }
    float factor[C][C];
    float inverse[C];
    if (!factor_triangle<C>(corner + j, front.pivot_leading, factor, inverse)) {
        return false;
    }
    for (int i = start; i < front.pivots; i += width) {
        Tile<1, C> tile;
        tile.take(corner + i, front.pivot_leading);
        tile.finish(factor, inverse);
        tile.put(corner + i, front.pivot_leading);
    }
    for (int c = 0; c < C; ++c) {
        for (int r = 0; r < C; ++r) {
            corner[std::ptrdiff_t{front.pivot_leading} * c + j + r] = r < c ? 0.0F : factor[r][c];
        }
    }
    int i = 0;
    for (; i + 2 * width <= front.below_leading; i += 2 * width) {
        eliminate_tile<2, C>(front, j, i, factor, inverse);
    }
    for (; i < front.below_rows; i += width) {
        eliminate_tile<1, C>(front, j, i, factor, inverse);
    }
    return true;
}

template <int R, int C>
inline void rest_tile(const Front& front, int j, int i) {
    Tile<R, C> tile;
    float* const own = front.rest + std::ptrdiff_t{front.below_leading} * j + i;
    if (front.fresh) {
        tile.clear();
    } else {
        tile.take(own, front.below_leading);
    }
    tile.subtract(front.below + i, front.below_leading, front.below + j, front.below_leading, front.pivots);
    tile.put(own, front.below_leading);
}

/// What the eliminated columns leave of C columns from j on.
template <int C>
inline void rest_columns(const Front& front, int j) {
    int i = j / width * width;
    for (; i + tile_rows * width <= front.below_leading; i += tile_rows * width) {
        rest_tile<tile_rows, C>(front, j, i);
    }
    if constexpr (tile_rows > 2) {
        if (i + 2 * width <= front.below_leading) {
            rest_tile<2, C>(front, j, i);
            i += 2 * width;
        }
    }
    for (; i < front.below_rows; i += width) {
        rest_tile<1, C>(front, j, i);
    }
}

bool eliminate(const Front& front) {
    int j = 0;
    for (; j + 6 <= front.pivots; j += 6) {
        if (!eliminate_columns<6>(front, j)) {
            return false;
        }
    }
    if (j < front.pivots && !eliminate_columns<3>(front, j)) {
        return false;
    }
    for (j = 0; j + 6 <= front.below_rows; j += 6) {
        rest_columns<6>(front, j);
    }
    if (j < front.below_rows) {
        rest_columns<3>(front, j);
    }
    return true;
}

/// From rows in `work` to columns.
inline void put_transposed(const float* work, int length, int columns, float* to) {
    const int height = rounded(columns);
    for (int c = 0; c < columns; ++c, to += height) {
        for (int r = 0; r < c; ++r) {
            to[r] = 0.0F;
        }
        for (int r = c; r < columns; ++r) {
            to[r] = work[std::ptrdiff_t{length} * r + c];
        }
        for (int r = columns; r < height; ++r) {
            to[r] = 0.0F;
        }
    }
}

/// Row i of the inverse: (e_i - sum over k < i of L_ik times row k) / L_ii.
inline void invert_any(const float* triangle, int leading, int columns, float* work) {
    const int length = (columns + front_unit - 1) / front_unit * front_unit;
    for (int i = 0; i < columns; ++i) {
        float* const own = work + std::ptrdiff_t{length} * i;
        const float scale = 1.0F / triangle[std::ptrdiff_t{leading} * i + i];
        for (int c = 0; c <= i; c += width) {
            Lanes sum = {};
            for (int k = c; k < i; ++k) {
                sum -= load<Lanes>(work + std::ptrdiff_t{length} * k + c) * triangle[std::ptrdiff_t{leading} * k + i];
            }
            store(own + c, sum * scale);
        }
        own[i] = scale;
    }
}

/// The same, with what is between the rows kept in registers.
template <int columns>
inline void invert_few(const float* triangle, int leading, float* work) {
    for (int c = 0; c < columns; c += width) {
        Lanes row[columns];
#pragma GCC unroll 12
        for (int i = 0; i < columns; ++i) {
            const float scale = 1.0F / triangle[std::ptrdiff_t{leading} * i + i];
            Lanes sum = {};
#pragma GCC unroll 12
            for (int k = 0; k < i; ++k) {
                sum -= row[k] * triangle[std::ptrdiff_t{leading} * k + i];
            }
            sum *= scale;
            if (i >= c && i < c + width) {
                sum[i - c] = scale;
            }
            row[i] = sum;
            store(work + front_unit * i + c, sum);
        }
    }
}

template <int columns>
inline void invert_few(const float* triangle, int leading, float* work, float* inverse) {
    invert_few<columns>(triangle, leading, work);
    put_transposed(work, front_unit, columns, inverse);
}

void invert(const float* triangle, int leading, int columns, float* work, float* inverse) {
    switch (columns) {
        case 3:
            return invert_few<3>(triangle, leading, work, inverse);
        case 6:
            return invert_few<6>(triangle, leading, work, inverse);
        case 9:
            return invert_few<9>(triangle, leading, work, inverse);
        case 12:
            return invert_few<12>(triangle, leading, work, inverse);
        default:
            invert_any(triangle, leading, columns, work);
            put_transposed(work, (columns + front_unit - 1) / front_unit * front_unit, columns, inverse);
    }
}

inline void clear(float* from, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = 0; i < count; i += front_unit) {
        for (int r = 0; r < front_unit; r += width) {
            store(from + i + r, Lanes{});
        }
    }
}

/// One block of a matrix, transposed.
inline void gather_block(const double* block, float* target, std::ptrdiff_t leading) {
    typedef double EightDoubles __attribute__((vector_size(64)));
    const Eight all = __builtin_convertvector(load<EightDoubles>(block), Eight);
    const Eight first = __builtin_shufflevector(all, all, 0, 3, 6, 1, 4, 7, 2, 5);
    store(target, Two{first[0], first[1]});
    target[2] = first[2];
    store(target + leading, Two{first[3], first[4]});
    target[leading + 2] = first[5];
    store(target + 2 * leading, Two{first[6], first[7]});
    target[2 * leading + 2] = static_cast<float>(block[8]);
}

void gather(const Blocks& matrix, const int* diagonal, const int* place, int first, const Front& front) {
    clear(front.pivot, std::ptrdiff_t{front.pivot_leading} * front.pivots);
    clear(front.below, std::ptrdiff_t{front.below_leading} * front.pivots);
    if (!front.fresh) {
        for (int j = 0; j < front.below_rows; ++j) {
            const int i = j / front_unit * front_unit;
            clear(front.rest + std::ptrdiff_t{front.below_leading} * j + i, front.below_leading - i);
        }
    }
    const int nodes = front.pivots / 3;
    for (int k = 0; k < nodes; ++k) {
        int slot = diagonal[first + k];
        const int end = matrix.first[first + k + 1];
        float* const inside = front.pivot + std::ptrdiff_t{front.pivot_leading} * (3 * k);
        for (; slot < end && place[slot] < nodes; ++slot) {
            gather_block(matrix.value + std::ptrdiff_t{9} * slot, inside + 3 * place[slot], front.pivot_leading);
        }
        float* const below = front.below + std::ptrdiff_t{front.below_leading} * (3 * k) - 3 * nodes;
        for (; slot < end; ++slot) {
            gather_block(matrix.value + std::ptrdiff_t{9} * slot, below + 3 * place[slot], front.below_leading);
        }
    }
}

typedef int Bits __attribute__((vector_size(4 * width)));
/// A register that starts n before the middle keeps the first n numbers.
struct Masks {
    int value[2 * width] = {};
    constexpr Masks() {
        for (int i = 0; i < width; ++i) {
            value[i] = -1;
        }
    }
};
constexpr Masks masks;

/// Adds a block of rows by columns; what is behind the rows in their last register gets zero added.
inline void add_long(float* target, std::ptrdiff_t step, const float* source, std::ptrdiff_t leading, int rows,
                     int columns) {
    const int whole = rows / width * width;
    const Bits kept = load<Bits>(masks.value + width - (rows - whole));
    for (int c = 0; c < columns; ++c, target += step, source += leading) {
        for (int r = 0; r < whole; r += width) {
            store(target + r, load<Lanes>(target + r) + load<Lanes>(source + r));
        }
        if (whole < rows) {
            const Lanes last = reinterpret_cast<Lanes>(kept & load<Bits>(source + whole));
            store(target + whole, load<Lanes>(target + whole) + last);
        }
    }
}

/// The same of so few rows that their number is known to the compiler.
template <int rows>
inline void add_short(float* target, std::ptrdiff_t step, const float* source, std::ptrdiff_t leading, int columns) {
    for (int c = 0; c < columns; ++c, target += step, source += leading) {
        int r = 0;
        if constexpr (rows >= 8) {
            store(target, load<Eight>(target) + load<Eight>(source));
            r = 8;
        }
        if constexpr (rows % 8 >= 4) {
            store(target + r, load<Four>(target + r) + load<Four>(source + r));
            r += 4;
        }
        if constexpr (rows % 4 >= 2) {
            store(target + r, load<Two>(target + r) + load<Two>(source + r));
            r += 2;
        }
        if constexpr (rows % 2 == 1) {
            target[r] += source[r];
        }
    }
}

inline void add_run(float* target, std::ptrdiff_t step, const float* source, std::ptrdiff_t leading, int nodes,
                    int columns) {
    switch (nodes) {
        case 1:
            return add_short<3>(target, step, source, leading, columns);
        case 2:
            return add_short<6>(target, step, source, leading, columns);
        case 3:
            return add_short<9>(target, step, source, leading, columns);
        case 4:
            return add_short<12>(target, step, source, leading, columns);
        default:
            return add_long(target, step, source, leading, 3 * nodes, columns);
    }
}

void extend(const float* source, int leading, const Run* runs, int count, const Front& front) {
    const int nodes = front.pivots / 3;
    for (int across = 0; across < count; ++across) {
        const Run& own = runs[across];
        const bool inside = own.place < nodes;
        const float* const from = source + std::ptrdiff_t{leading} * (3 * own.from);
        const std::ptrdiff_t step = inside ? front.pivot_leading : front.below_leading;
        // its triangle
        float* const corner =
            inside ? front.pivot + (step + 1) * (3 * own.place) : front.rest + (step + 1) * (3 * (own.place - nodes));
        for (int b = 0; b < own.nodes; ++b) {
            add_run(corner + (step + 1) * (3 * b), step, from + std::ptrdiff_t{leading} * (3 * b) + 3 * (own.from + b),
                    leading, own.nodes - b, 3);
        }
        // the rows below it
        float* const below = inside ? front.below + std::ptrdiff_t{front.below_leading} * (3 * own.place)
                                    : front.rest + step * (3 * (own.place - nodes));
        for (int down = across + 1; down < count; ++down) {
            const Run& rows = runs[down];
            const bool among_pivots = rows.place < nodes;
            float* const target =
                among_pivots ? front.pivot + step * (3 * own.place) + 3 * rows.place : below + 3 * (rows.place - nodes);
            add_run(target, among_pivots ? step : front.below_leading, from + 3 * rows.from, leading, rows.nodes,
                    3 * own.nodes);
        }
    }
}

// --- solves ----------------------------------------------------------------------------------------------------------

/// y = B x for 8 U rows.
template <int U>
inline void block_times(const float* block, int leading, int columns, const float* x, float* y) {
    Eight sum[U] = {};
    for (int j = 0; j < columns; ++j, block += leading) {
        for (int u = 0; u < U; ++u) {
            sum[u] += load<Eight>(block + 8 * u) * x[j];
        }
    }
    for (int u = 0; u < U; ++u) {
        store(y + 8 * u, sum[u]);
    }
}

/// Eight running sums of B' y per column, added to `sums`.
template <int U>
inline void transposed_times(const float* block, int leading, int columns, const float* y, float* sums) {
    Eight rows[U];
    for (int u = 0; u < U; ++u) {
        rows[u] = load<Eight>(y + 8 * u);
    }
    for (int j = 0; j < columns; ++j, block += leading) {
        Eight sum = load<Eight>(sums + 8 * j);
        for (int u = 0; u < U; ++u) {
            sum += load<Eight>(block + 8 * u) * rows[u];
        }
        store(sums + 8 * j, sum);
    }
}

inline void times(int rows, const float* block, int leading, int columns, const float* x, float* y) {
    switch (rows) {
        case 8:
            return block_times<1>(block, leading, columns, x, y);
        case 16:
            return block_times<2>(block, leading, columns, x, y);
        case 24:
            return block_times<3>(block, leading, columns, x, y);
        case 32:
            return block_times<4>(block, leading, columns, x, y);
        case 40:
            return block_times<5>(block, leading, columns, x, y);
        case 48:
            return block_times<6>(block, leading, columns, x, y);
        case 56:
            return block_times<7>(block, leading, columns, x, y);
        default:
            return block_times<8>(block, leading, columns, x, y);
    }
}

inline void times_transposed(int rows, const float* block, int leading, int columns, const float* y, float* sums) {
    switch (rows) {
        case 8:
            return transposed_times<1>(block, leading, columns, y, sums);
        case 16:
            return transposed_times<2>(block, leading, columns, y, sums);
        case 24:
            return transposed_times<3>(block, leading, columns, y, sums);
        case 32:
            return transposed_times<4>(block, leading, columns, y, sums);
        case 40:
            return transposed_times<5>(block, leading, columns, y, sums);
        case 48:
            return transposed_times<6>(block, leading, columns, y, sums);
        case 56:
            return transposed_times<7>(block, leading, columns, y, sums);
        default:
            return transposed_times<8>(block, leading, columns, y, sums);
    }
}

inline float total(const float* sums) {
    const Four halves = load<Four>(sums) + load<Four>(sums + 4);
    return (halves[0] + halves[2]) + (halves[1] + halves[3]);
}

inline void take(const float* x, int nodes, float* packed) {
    for (int k = 0; k < nodes; ++k) {
        store(packed + 3 * k, load<Four>(x + 4 * k));
    }
}

inline void put(const float* packed, int nodes, float* x) {
    for (int k = 0; k < nodes; ++k) {
        x[4 * k] = packed[3 * k];
        x[4 * k + 1] = packed[3 * k + 1];
        x[4 * k + 2] = packed[3 * k + 2];
    }
}

inline void forward(const Panel& panel, const float* values, const int* nodes, float* x, float* work) {
    float* const own = x + 4 * panel.first_node;
    const int own_nodes = panel.width / 3;
    float* const result = work + rounded(panel.width) + row_unit;
    take(own, own_nodes, work);
    times(rounded(panel.width), values + panel.triangle, rounded(panel.width), panel.width, work, result);
    put(result, own_nodes, own);
    const int below = 3 * panel.below_nodes;
    float* const change = result + rounded(panel.width) + row_unit;
    for (int i = 0; i < below; i += row_block) {
        times(smaller(row_block, rounded(below - i)), values + panel.below + i, panel.leading, panel.width, result,
              change + i);
    }
    const int* const rows = nodes + panel.row;
    for (int k = 0; k < panel.below_nodes; ++k) {
        float* const place = x + 4 * rows[k];
        Four value = load<Four>(change + 3 * k);
        value[3] = 0.0F;
        store(place, load<Four>(place) - value);
    }
}

inline void backward(const Panel& panel, const float* values, const int* nodes, float* x, float* work) {
    float* const own = x + 4 * panel.first_node;
    const int own_nodes = panel.width / 3;
    const int below = 3 * panel.below_nodes;
    float* const sums = work;
    float* const packed = sums + 8 * panel.width;
    float* const rest = packed + rounded(panel.width) + row_unit;
    for (int j = 0; j < 8 * panel.width; j += 8) {
        store(sums + j, Eight{});
    }
    const int* const rows = nodes + panel.row;
    for (int k = 0; k < panel.below_nodes; ++k) {
        store(rest + 3 * k, load<Four>(x + 4 * rows[k]));
    }
    store(rest + below, Eight{});
    for (int i = 0; i < below; i += row_block) {
        times_transposed(smaller(row_block, rounded(below - i)), values + panel.below + i, panel.leading, panel.width,
                         rest + i, sums);
    }
    take(own, own_nodes, packed);
    store(packed + panel.width, Eight{});
    for (int j = 0; j < panel.width; ++j) {
        packed[j] -= total(sums + 8 * j);
        store(sums + 8 * j, Eight{});
    }
    times_transposed(rounded(panel.width), values + panel.triangle, rounded(panel.width), panel.width, packed, sums);
    for (int k = 0; k < own_nodes; ++k) {
        for (int c = 0; c < 3; ++c) {
            own[4 * k + c] = total(sums + 8 * (3 * k + c));
        }
    }
}

void solve(const Panel* panels, int count, const float* values, const int* nodes, float* x, float* work) {
    for (int s = 0; s < count; ++s) {
        forward(panels[s], values, nodes, x, work);
    }
    for (int s = count - 1; s >= 0; --s) {
        backward(panels[s], values, nodes, x, work);
    }
}

// --- products --------------------------------------------------------------------------------------------------------

/// The fourth lane gathers numbers of the next column, which are never used.
void multiply(const Blocks& matrix, const double* x, double* y) {
    for (int i = 0; i < matrix.rows; ++i) {
        Node first = {};
        Node second = {};
        Node third = {};
        const int end = matrix.first[i + 1];
        for (int slot = matrix.first[i]; slot < end; ++slot) {
            const double* const block = matrix.value + std::ptrdiff_t{9} * slot;
            const double* const part = x + std::ptrdiff_t{3} * matrix.column[slot];
            first += load<Node>(block) * part[0];
            second += load<Node>(block + 3) * part[1];
            third += load<Node>(block + 6) * part[2];
        }
        const Node sum = (first + second) + third;
        double* const row = y + std::ptrdiff_t{3} * i;
        row[0] = sum[0];
        row[1] = sum[1];
        row[2] = sum[2];
    }
}

typedef double Many __attribute__((vector_size(8 * many)));

void multiply_many(const Blocks& matrix, const double* x, double* y) {
    for (int i = 0; i < matrix.rows; ++i) {
        Many sum[3] = {};
        const int end = matrix.first[i + 1];
        for (int slot = matrix.first[i]; slot < end; ++slot) {
            const double* const block = matrix.value + std::ptrdiff_t{9} * slot;
            const double* const part = x + std::ptrdiff_t{3} * many * matrix.column[slot];
            for (int c = 0; c < 3; ++c) {
                const Many own = load<Many>(part + many * c);
                for (int r = 0; r < 3; ++r) {
                    sum[r] += own * block[3 * c + r];
                }
            }
        }
        for (int r = 0; r < 3; ++r) {
            store(y + many * (std::ptrdiff_t{3} * i + r), sum[r]);
        }
    }
}

void products_many(const double* x, const double* y, const double* b, std::size_t n, double* with_y, double* with_b) {
    Many sums[many] = {};
    Many sum = {};
    for (std::size_t i = 0; i < n; ++i) {
        const Many own = load<Many>(y + many * i);
        for (int k = 0; k < many; ++k) {
            sums[k] += own * x[many * i + k];
        }
        sum += load<Many>(x + many * i) * b[i];
    }
    for (int k = 0; k < many; ++k) {
        store(with_y + many * k, sums[k]);
    }
    store(with_b, sum);
}

void combine_many(const double* x, const double* factors, std::size_t n, double* sum) {
    const Many own = load<Many>(factors);
    for (std::size_t i = 0; i < n; ++i) {
        const Many all = load<Many>(x + many * i) * own;
        sum[i] = ((all[0] + all[4]) + (all[2] + all[6])) + ((all[1] + all[5]) + (all[3] + all[7]));
    }
}

double dot(const double* a, const double* b, std::size_t n) {
    Node even = {};
    Node odd = {};
    std::size_t i = 0;
    for (; i + 8 <= n; i += 8) {
        even += load<Node>(a + i) * load<Node>(b + i);
        odd += load<Node>(a + i + 4) * load<Node>(b + i + 4);
    }
    const Node sum = even + odd;
    double result = (sum[0] + sum[2]) + (sum[1] + sum[3]);
    for (; i < n; ++i) {
        result += a[i] * b[i];
    }
    return result;
}
