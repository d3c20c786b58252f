// SPDX-License-Identifier: GPL-3.0-or-later
// Body of the linear kernel for RHEXIS_WIDTH floats at a time; included once per instruction set, in a namespace of its
// own. Tiles differ in size between instruction sets; the sums they form do not.

constexpr int width = RHEXIS_WIDTH;
constexpr int tile_rows = RHEXIS_TILE;  // registers of rows in a tile
typedef float Lanes __attribute__((vector_size(4 * width)));
typedef float Eight __attribute__((vector_size(32)));
typedef float Four __attribute__((vector_size(16)));
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

// --- elimination -----------------------------------------------------------------------------------------------------

/// Rows i .. of `columns` columns from j on, less the products of the first `depth` columns.
template <int R, int C>
inline void update_tile(float* front, int leading, int depth, int i, int j) {
    Lanes sum[C][R];
    for (int c = 0; c < C; ++c) {
        for (int r = 0; r < R; ++r) {
            sum[c][r] = load<Lanes>(front + std::ptrdiff_t{leading} * (j + c) + i + r * width);
        }
    }
    const float* column = front;
    for (int k = 0; k < depth; ++k, column += leading) {
        Lanes rows[R];
        for (int r = 0; r < R; ++r) {
            rows[r] = load<Lanes>(column + i + r * width);
        }
        for (int c = 0; c < C; ++c) {
            const float factor = column[j + c];
            for (int r = 0; r < R; ++r) {
                sum[c][r] -= rows[r] * factor;
            }
        }
    }
    for (int c = 0; c < C; ++c) {
        for (int r = 0; r < R; ++r) {
            store(front + std::ptrdiff_t{leading} * (j + c) + i + r * width, sum[c][r]);
        }
    }
}

template <int C>
inline void update_columns(float* front, int leading, int depth, int j) {
    int i = j / front_unit * front_unit;
    for (; i + tile_rows * width <= leading; i += tile_rows * width) {
        update_tile<tile_rows, C>(front, leading, depth, i, j);
    }
    for (; i < leading; i += width) {
        update_tile<1, C>(front, leading, depth, i, j);
    }
}

inline void update(float* front, int leading, int depth, int begin, int end) {
    int j = begin;
    for (; j + 6 <= end; j += 6) {
        update_columns<6>(front, leading, depth, j);
    }
    if (j < end) {
        update_columns<3>(front, leading, depth, j);
    }
}

/// Cholesky of C columns from j on, which need no more products of earlier ones.
template <int C>
inline bool eliminate_columns(float* front, int leading, int j) {
    float* column[C];
    for (int c = 0; c < C; ++c) {
        column[c] = front + std::ptrdiff_t{leading} * (j + c);
    }
    float inverse[C];
    float factor[C][C];
    for (int c = 0; c < C; ++c) {
        for (int r = c; r < C; ++r) {
            float sum = column[c][j + r];
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
        for (int r = c + 1; r < C; ++r) {
            factor[r][c] *= inverse[c];
        }
    }
    for (int i = j / front_unit * front_unit; i < leading; i += width) {
        Lanes own[C];
        for (int c = 0; c < C; ++c) {
            own[c] = load<Lanes>(column[c] + i);
            for (int k = 0; k < c; ++k) {
                own[c] -= own[k] * factor[c][k];
            }
            own[c] *= inverse[c];
            store(column[c] + i, own[c]);
        }
    }
    for (int c = 0; c < C; ++c) {
        for (int r = 0; r < C; ++r) {
            column[c][j + r] = r < c ? 0.0F : factor[r][c];
        }
    }
    return true;
}

bool eliminate(float* front, int leading, int pivots, int size) {
    for (int j = 0; j < pivots; j += 6) {
        const bool whole = j + 6 <= pivots;
        update(front, leading, j, j, whole ? j + 6 : pivots);
        if (!(whole ? eliminate_columns<6>(front, leading, j) : eliminate_columns<3>(front, leading, j))) {
            return false;
        }
    }
    update(front, leading, pivots, pivots, size);
    return true;
}

/// Row i of the inverse: (e_i - sum over k < i of L_ik times row k) / L_ii.
void invert(const float* triangle, int leading, int columns, float* inverse) {
    const int length = (columns + front_unit - 1) / front_unit * front_unit;
    for (int i = 0; i < columns; ++i) {
        float* const own = inverse + std::ptrdiff_t{length} * i;
        const float scale = 1.0F / triangle[std::ptrdiff_t{leading} * i + i];
        for (int c = 0; c < length; c += width) {
            Lanes sum = {};
            for (int k = c; k < i; ++k) {
                sum -=
                    load<Lanes>(inverse + std::ptrdiff_t{length} * k + c) * triangle[std::ptrdiff_t{leading} * k + i];
            }
            store(own + c, sum * scale);
        }
        own[i] = scale;
    }
}

template <typename Register>
inline void add_register(float* target, const float* source) {
    store(target, load<Register>(target) + load<Register>(source));
}

/// count: a multiple of 3. Mostly short, so what is left of whole registers goes by halves.
inline void add_to(float* target, const float* source, int count) {
    int r = 0;
    for (; r + width <= count; r += width) {
        add_register<Lanes>(target + r, source + r);
    }
    if (r + 8 <= count) {
        add_register<Eight>(target + r, source + r);
        r += 8;
    }
    if (r + 4 <= count) {
        add_register<Four>(target + r, source + r);
        r += 4;
    }
    switch (count - r) {
        case 3:
            target[r + 2] += source[r + 2];
            [[fallthrough]];
        case 2:
            target[r + 1] += source[r + 1];
            [[fallthrough]];
        case 1:
            target[r] += source[r];
            break;
        default:
            break;
    }
}

void extend(const float* source, const int* place, int nodes, float* front, int leading) {
    const int height = 3 * nodes;
    for (int b = 0; b < nodes; ++b) {
        float* const column = front + std::ptrdiff_t{leading} * (3 * place[b]);
        const float* const own = source + std::ptrdiff_t{height} * (3 * b);
        for (int a = b; a < nodes;) {
            int end = a + 1;
            while (end < nodes && place[end] == place[end - 1] + 1) {
                ++end;
            }
            for (int c = 0; c < 3; ++c) {
                add_to(column + std::ptrdiff_t{leading} * c + 3 * place[a], own + std::ptrdiff_t{height} * c + 3 * a,
                       3 * (end - a));
            }
            a = end;
        }
    }
}

// --- solves ----------------------------------------------------------------------------------------------------------

inline int rounded(int rows) { return (rows + row_unit - 1) / row_unit * row_unit; }
inline int smaller(int a, int b) { return a < b ? a : b; }

/// y = B x for a block of 8 U rows by columns.
template <int U>
inline void block_times(const float* block, int columns, const float* x, float* y) {
    Eight sum[U] = {};
    for (int j = 0; j < columns; ++j, block += 8 * U) {
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
inline void transposed_times(const float* block, int columns, const float* y, float* sums) {
    Eight rows[U];
    for (int u = 0; u < U; ++u) {
        rows[u] = load<Eight>(y + 8 * u);
    }
    for (int j = 0; j < columns; ++j, block += 8 * U) {
        Eight sum = load<Eight>(sums + 8 * j);
        for (int u = 0; u < U; ++u) {
            sum += load<Eight>(block + 8 * u) * rows[u];
        }
        store(sums + 8 * j, sum);
    }
}

inline void times(int rows, const float* block, int columns, const float* x, float* y) {
    switch (rows) {
        case 8:
            return block_times<1>(block, columns, x, y);
        case 16:
            return block_times<2>(block, columns, x, y);
        case 24:
            return block_times<3>(block, columns, x, y);
        case 32:
            return block_times<4>(block, columns, x, y);
        case 40:
            return block_times<5>(block, columns, x, y);
        case 48:
            return block_times<6>(block, columns, x, y);
        case 56:
            return block_times<7>(block, columns, x, y);
        default:
            return block_times<8>(block, columns, x, y);
    }
}

inline void times_transposed(int rows, const float* block, int columns, const float* y, float* sums) {
    switch (rows) {
        case 8:
            return transposed_times<1>(block, columns, y, sums);
        case 16:
            return transposed_times<2>(block, columns, y, sums);
        case 24:
            return transposed_times<3>(block, columns, y, sums);
        case 32:
            return transposed_times<4>(block, columns, y, sums);
        case 40:
            return transposed_times<5>(block, columns, y, sums);
        case 48:
            return transposed_times<6>(block, columns, y, sums);
        case 56:
            return transposed_times<7>(block, columns, y, sums);
        default:
            return transposed_times<8>(block, columns, y, sums);
    }
}

inline float total(const float* sums) {
    const Four halves = load<Four>(sums) + load<Four>(sums + 4);
    return (halves[0] + halves[2]) + (halves[1] + halves[3]);
}

/// y = T x with the triangle T of a panel; y padded.
inline void triangle_times(const Panel& panel, const float* values, const float* x, float* y) {
    const float* block = values + panel.triangle;
    for (int i = 0; i < panel.width; i += row_block) {
        const int rows = smaller(row_block, rounded(panel.width - i));
        const int columns = smaller(panel.width, i + row_block);
        times(rows, block, columns, x, y + i);
        block += rows * columns;
    }
}

inline void triangle_transposed(const Panel& panel, const float* values, const float* y, float* sums) {
    const float* block = values + panel.triangle;
    for (int i = 0; i < panel.width; i += row_block) {
        const int rows = smaller(row_block, rounded(panel.width - i));
        const int columns = smaller(panel.width, i + row_block);
        times_transposed(rows, block, columns, y + i, sums);
        block += rows * columns;
    }
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
    triangle_times(panel, values, work, result);
    put(result, own_nodes, own);
    const int below = 3 * panel.below_nodes;
    float* const change = result + rounded(panel.width) + row_unit;
    const float* block = values + panel.below;
    for (int i = 0; i < below; i += row_block) {
        const int rows = smaller(row_block, rounded(below - i));
        times(rows, block, panel.width, result, change + i);
        block += rows * panel.width;
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
    const float* block = values + panel.below;
    for (int i = 0; i < below; i += row_block) {
        const int count = smaller(row_block, rounded(below - i));
        times_transposed(count, block, panel.width, rest + i, sums);
        block += count * panel.width;
    }
    take(own, own_nodes, packed);
    store(packed + panel.width, Eight{});
    for (int j = 0; j < panel.width; ++j) {
        packed[j] -= total(sums + 8 * j);
        store(sums + 8 * j, Eight{});
    }
    triangle_transposed(panel, values, packed, sums);
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
