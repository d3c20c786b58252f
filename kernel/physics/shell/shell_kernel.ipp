// SPDX-License-Identifier: GPL-3.0-or-later
// Body of the shell kernel for RHEXIS_WIDTH doubles at a time; included once per instruction set, in a namespace of its
// own.

#include "physics/solve/lanes.ipp"
#include "energy/shell_triangle.ipp"

static_assert(rest_length == data_length && blocks + 3 == index_length &&
              rest_length == natural_place + natural_length && sizeof(Rest<Lanes>) == rest_length * sizeof(Lanes));

inline void gather(const Task& task, const int* index, Now<Lanes>& now) {
    for (int a = 0; a < 3; ++a) {
        for (int l = 0; l < width; ++l) {
            const long rank = index[lanes * a + l];
            const double* const position = task.position + 6 * rank;
            const double* const rotation = task.rotation + 9 * rank;
            for (int i = 0; i < 3; ++i) {
                now.position[a][i][l] = position[i];
                for (int j = 0; j < 3; ++j) {
                    now.rotation[a].m[i][j][l] = rotation[3 * i + j];
                }
            }
        }
    }
}

/// buffer: lanes times its numbers.
inline void add_forces(const Task& task, const int* index) {
    for (int l = 0; l < lanes; ++l) {
        for (int a = 0; a < 3; ++a) {
            double* const force = task.force + 6 * static_cast<long>(index[lanes * a + l]);
            for (int i = 0; i < 6; ++i) {
                force[i] -= task.buffer[lanes * (6 * a + i) + l];
            }
        }
    }
}

inline void add_stiffness(const Task& task, const int* index) {
    const double* const values = task.buffer + 18 * lanes;
    for (int l = 0; l < lanes; ++l) {
        for (int b = 0; b < blocks; ++b) {
            double* const block = task.stiffness + index[lanes * (3 + b) + l];
            for (int i = 0; i < 9; ++i) {
                block[i] += values[lanes * (9 * b + i) + l];
            }
        }
    }
}

inline void load_stress(const double* from, Deformed<Lanes>& d) {
    for (int a = 0; a < 3; ++a) {
        for (int i = 0; i < 3; ++i) {
            d.force[a][i] = load(from + lanes * (3 * a + i));
            d.moment[a][i] = load(from + lanes * (9 + 3 * a + i));
        }
    }
}

inline void predict_stress(const Task& task, const int* index, const Rest<Lanes>& rest, Deformed<Lanes>& d,
                           double* to) {
    Triple<Lanes> movement[3];
    Triple<Lanes> spin[3];
    for (int a = 0; a < 3; ++a) {
        for (int l = 0; l < width; ++l) {
            const double* const step = task.step + 6 * static_cast<long>(index[lanes * a + l]);
            for (int i = 0; i < 3; ++i) {
                movement[a][i][l] = step[i];
                spin[a][i][l] = step[3 + i];
            }
        }
    }
    predict(rest, movement, spin, d);
    for (int a = 0; a < 3; ++a) {
        for (int i = 0; i < 3; ++i) {
            store(to + lanes * (3 * a + i), d.force[a][i]);
            store(to + lanes * (9 + 3 * a + i), d.moment[a][i]);
        }
    }
}

inline void store_deformation(const Deformed<Lanes>& d, double* to) {
    for (int a = 0; a < 3; ++a) {
        store(to + lanes * (5 * a), d.moved[a][0]);
        store(to + lanes * (5 * a + 1), d.moved[a][1]);
        for (int i = 0; i < 3; ++i) {
            store(to + lanes * (5 * a + 2 + i), d.turned[a][i]);
        }
    }
}

/// predicted: of these triangles, or null; deformation likewise.
template <Mode mode>
inline void evaluate(const Task& task, const double* data, const int* index, double* predicted, double* deformation,
                     int first) {
    Rest<Lanes> rest;
    Lanes* const numbers = reinterpret_cast<Lanes*>(&rest);
    for (int i = 0; i < rest_length; ++i) {
        numbers[i] = load(data + lanes * i + first);
    }
    Now<Lanes> now;
    gather(task, index + first, now);
    Deformed<Lanes> d;
    if constexpr (mode == Mode::deformation) {
        find_deformation(rest, now, d);
        return store_deformation(d, deformation + first);
    }
    deform(rest, now, d);
    if constexpr (mode == Mode::predict) {
        return predict_stress(task, index + first, rest, d, predicted + first);
    }
    for (int a = 0; a < 3; ++a) {
        const Triple<Lanes> force = times(d.frame, d.gradient_force[a]);
        const Triple<Lanes> moment = times(d.frame, d.lifted[a]);
        for (int i = 0; i < 3; ++i) {
            store(task.buffer + lanes * (6 * a + i) + first, force[i]);
            store(task.buffer + lanes * (6 * a + 3 + i) + first, moment[i]);
        }
    }
    if constexpr (mode == Mode::consistent) {
        if (predicted != nullptr) {
            load_stress(predicted + first, d);
            find_resultants(rest, d);
        }
    }
    if constexpr (mode != Mode::forces) {
        Tangent<Lanes> t;
        tangent<Lanes, mode == Mode::consistent>(rest, d, t);
        const Lanes scale = Lanes{} + task.scale;
        double* to = task.buffer + 18 * lanes + first;
        for (int b = 0; b < blocks; ++b) {
            for (int j = 0; j < 3; ++j) {
                for (int i = 0; i < 3; ++i, to += lanes) {
                    store(to, scale * t.block[b].m[i][j]);
                }
            }
        }
    }
}

template <Mode mode>
void assemble_groups(const Task& task) {
    for (int g = 0; g < task.groups; ++g) {
        const double* const data = task.data + static_cast<long>(lanes) * data_length * g;
        const int* const index = task.index + static_cast<long>(lanes) * index_length * g;
        double* const predicted =
            task.predicted == nullptr ? nullptr : task.predicted + static_cast<long>(lanes) * predicted_length * g;
        double* const deformation =
            task.deformation == nullptr ? nullptr : task.deformation + static_cast<long>(lanes) * natural_length * g;
        for (int first = 0; first < lanes; first += width) {
            evaluate<mode>(task, data, index, predicted, deformation, first);
        }
        if constexpr (mode != Mode::predict && mode != Mode::deformation) {
            add_forces(task, index);
        }
        if constexpr (mode == Mode::consistent || mode == Mode::definite) {
            add_stiffness(task, index);
        }
    }
}

void assemble(const Task& task) {
    switch (task.mode) {
        case Mode::forces:
            return assemble_groups<Mode::forces>(task);
        case Mode::consistent:
            return assemble_groups<Mode::consistent>(task);
        case Mode::definite:
            return assemble_groups<Mode::definite>(task);
        case Mode::predict:
            return assemble_groups<Mode::predict>(task);
        case Mode::deformation:
            return assemble_groups<Mode::deformation>(task);
    }
}
