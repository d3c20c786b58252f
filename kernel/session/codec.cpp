// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/codec.hpp"

#include "session/bytes.hpp"

// One function per struct names its fields for both directions: `io` is a writer with const structs, or a reader.
namespace rhexis {
namespace {

class Writing {
public:
    template <typename T>
    void operator()(const T& value) {
        writer.put(value);
    }
    template <typename T, typename Fields>
    void list(const std::vector<T>& items, std::size_t, const Fields& fields) {
        writer.put(static_cast<std::uint64_t>(items.size()));
        for (const T& item : items) {
            fields(*this, item);
        }
    }
    template <typename T, typename Fields>
    void maybe(const std::optional<T>& item, const Fields& fields) {
        writer.put(item.has_value());
        if (item) {
            fields(*this, *item);
        }
    }
    void limit(bool) {}
    ByteWriter writer;
};

class Reading {
public:
    explicit Reading(std::string_view bytes) : reader(bytes) {}
    template <typename T>
    void operator()(T& value) {
        reader.get(value);
    }
    template <typename T, typename Fields>
    void list(std::vector<T>& items, std::size_t item_bytes, const Fields& fields) {
        items.resize(reader.count(item_bytes));
        for (T& item : items) {
            fields(*this, item);
        }
    }
    template <typename T, typename Fields>
    void maybe(std::optional<T>& item, const Fields& fields) {
        bool there = false;
        reader.get(there);
        if (there) {
            fields(*this, item.emplace());
        }
    }
    void limit(bool condition) { sound = sound && condition; }
    [[nodiscard]] bool good() const { return reader.ok() && reader.at_end() && sound; }
    ByteReader reader;
    bool sound = true;
};

void accuracy_fields(auto& io, auto& accuracy) {
    io(accuracy.step_s);
    io(accuracy.step_by_hand);
    io(accuracy.time_s);
    io.list(accuracy.models, 65, [](auto& inner, auto& model) {
        inner(model.model);
        inner(model.way);
        inner(model.mesh);
        inner(model.budget);
        inner(model.expected);
        inner(model.cost);
        inner(model.by_hand);
        inner(model.instead);
        inner(model.machine);
    });
}

void scene_fields(auto& io, auto& scene) {
    io(scene.patient.age);
    io(scene.patient.nuclear_grade);
    io(scene.patient.cortical_opacity);
    io(scene.patient.pupil_mm);
    io(scene.patient.side);
    io(scene.patient.tetrahedra);
    io(scene.tissues);
    io(scene.instruments);
    io(scene.step_s);
    io(scene.advance);
    io(scene.opening);
    io.limit(scene.advance >= Advance::automatic && scene.advance <= Advance::implicit);
    io(scene.threads);
    io(scene.settings);
    accuracy_fields(io, scene.accuracy);
}

void text_map(Writing& io, const std::map<std::string, std::string>& map) {
    io(static_cast<std::uint64_t>(map.size()));
    for (const auto& [key, value] : map) {
        io(key);
        io(value);
    }
}

void text_map(Reading& io, std::map<std::string, std::string>& map) {
    const std::size_t size = io.reader.count(2 * sizeof(std::uint64_t));
    for (std::size_t i = 0; i < size && io.reader.ok(); ++i) {
        std::string key;
        io(key);
        io(map[key]);
    }
}

void header_fields(auto& io, auto& header) {
    scene_fields(io, header.scene);
    io(header.seed);
    io(header.curriculum);
    io(header.identity);
    io(header.surgeon);
    text_map(io, header.set);
    io(header.build);
    io.list(header.schema, 24, [](auto& inner, auto& info) {
        inner(info.name);
        inner(info.unit);
        inner(info.meaning);
    });
}

void observation_fields(auto& io, auto& observation) {
    io(observation.time_s);
    io(observation.values);
}

void step_fields(auto& io, auto& step) {
    io(step.step);
    io.list(step.samples, 77, [](auto& inner, auto& sample) {
        inner(sample.instrument);
        inner(sample.present);
        inner(sample.pose);
        inner(sample.jaw);
        inner(sample.pedal);
    });
    io.list(step.commands, 28, [](auto& inner, auto& command) {
        inner(command.kind);
        inner.limit(command.kind >= CommandKind::set && command.kind <= CommandKind::note);
        inner(command.name);
        inner(command.value);
        inner(command.text);
    });
    observation_fields(io, step.observation);
    io(step.hash);
}

void wounds_fields(auto& io, auto& world) {
    io.maybe(world.wounds, [](auto& inner, auto& state) {
        for (auto& wound : state.wounds) {
            inner(wound.begun);
            inner(wound.cut);
            inner(wound.outer);
            inner(wound.inner);
            inner(wound.mark);
            inner(wound.heading);
            inner(wound.tunnel);
            inner(wound.planes);
            inner(wound.width);
            inner(wound.passed);
            inner(wound.left);
            inner(wound.right);
            inner(wound.peel);
            inner(wound.most_peel);
            inner(wound.swelling);
            inner(wound.sutures);
            inner(wound.distortion);
            inner(wound.gape);
            inner(wound.press);
            inner(wound.leak);
            inner(wound.fluid);
        }
        inner(state.touches);
        inner(state.touching);
        inner(state.catching);
        inner(state.caught_at);
        inner(state.stitching);
        inner(state.bite);
        inner(state.deepest);
        inner(state.pressed_s);
        inner(state.checked);
        inner(state.tested_leak);
        inner(state.peak_press);
        inner(state.aqueous);
        inner(state.injected);
        inner(state.source);
        inner(state.behind);
    });
}

void bag_contents_fields(auto& io, auto& world) {
    io.maybe(world.hydrodissection, [](auto& inner, auto& hydro) {
        inner(hydro.cleaved);
        inner(hydro.entry);
        inner(hydro.entered);
        inner(hydro.under_rim);
        inner(hydro.trapped);
        inner(hydro.injected);
        inner(hydro.filled);
        inner(hydro.lifted);
        inner(hydro.pressure);
        inner(hydro.peak_pressure);
        inner(hydro.strain);
        inner(hydro.burst_s);
    });
    io.maybe(world.cortex, [](auto& inner, auto& cortex) {
        inner(cortex.volume);
        inner(cortex.attached);
        inner(cortex.tool);
        inner(cortex.cell);
        inner(cortex.held);
        inner(cortex.place);
        inner(cortex.pull);
        inner(cortex.taken);
    });
    io.maybe(world.retained, [](auto& inner, auto& retained) {
        inner(retained.front);
        inner(retained.behind);
        inner(retained.angle);
        inner(retained.taken);
        inner(retained.rocked);
        inner(retained.under);
    });
}

void fluid_fields(auto& io, auto& world) {
    io.maybe(world.chamber, [](auto& inner, auto& chamber) {
        inner(chamber.eye_volume);
        inner(chamber.tube_volume);
        inner(chamber.totals.infused);
        inner(chamber.totals.vented);
        inner(chamber.totals.aspirated);
        inner(chamber.totals.leaked);
        inner(chamber.wound.temperature);
        inner(chamber.wound.hot_s);
    });
    auto& flows = world.flows;
    io(flows.infusion);
    io(flows.tip);
    io(flows.pump);
    io(flows.leak);
    io(flows.vent);
    io(flows.lowest_eye_pressure);
    io(flows.highest_eye_pressure);
    io.maybe(world.viscoelastic, [](auto& inner, auto& chamber) {
        inner(chamber.fill);
        inner(chamber.injected);
        inner(chamber.peak_fill);
    });
    io.maybe(world.vitreous, [](auto& inner, auto& vitreous) {
        inner(vitreous.broken);
        inner(vitreous.behind);
        inner(vitreous.drive);
        for (auto& volume : vitreous.front) {
            inner(volume);
        }
        inner(vitreous.wound);
        inner(vitreous.marked);
        inner(vitreous.cut);
        inner(vitreous.tool);
        inner(vitreous.caught);
        inner(vitreous.traction);
        inner(vitreous.peak_traction);
        inner(vitreous.checked);
        for (auto& volume : vitreous.plug) {
            inner(volume);
        }
        inner(vitreous.filled);
        inner(vitreous.given);
        inner(vitreous.open_s);
        inner(vitreous.inside);
    });
    io.maybe(world.globe, [](auto& inner, auto& globe) {
        inner(globe.roll);
        for (auto& lip : globe.lips) {
            inner(lip.excursion);
            inner(lip.deflection);
            inner(lip.enlargement);
        }
    });
    io.maybe(world.prolapse, [](auto& inner, auto& prolapse) {
        inner(prolapse.length);
        inner(prolapse.most);
        inner(prolapse.damage);
        inner(prolapse.pushed);
        inner(prolapse.stroke_s);
        inner(prolapse.pull);
    });
    bag_contents_fields(io, world);
    io.maybe(world.microscope, [](auto& inner, auto& microscope) { inner(microscope.position); });
    io.maybe(world.lids, [](auto& inner, auto& lids) {
        inner(lids.opening);
        inner.list(lids.covered, 1, [](auto& lash_io, auto& covered) {
            lash_io(covered);
            lash_io.limit(covered <= 1);
        });
        inner(lids.drip);
        for (auto& time : lids.tested) {
            inner(time);
        }
    });
    io.maybe(world.beads, [](auto& inner, auto& beads) {
        inner.list(beads.beads, 52, [](auto& bead_io, auto& bead) {
            bead_io(bead.position);
            bead_io(bead.off);
            bead_io(bead.tool);
        });
        inner(beads.grasps);
        inner(beads.drops);
    });
    io.maybe(world.capsule, [](auto& inner, auto& capsule) {
        inner(capsule.tool);
        inner(capsule.captured);
        inner(capsule.place);
        inner(capsule.depth);
        inner(capsule.strain);
        inner(capsule.force);
        inner(capsule.hole_radius);
        inner(capsule.hole_place);
        inner(capsule.peak_strain);
    });
    io.maybe(world.iris, [](auto& inner, auto& iris) {
        inner(iris.z);
        inner(iris.pupil_radius);
        inner(iris.tool);
        inner(iris.place);
        inner(iris.strain);
        inner(iris.torn);
    });
    io.list(world.debris, 72, [](auto& inner, auto& debris) {
        inner(debris.position);
        inner(debris.velocity);
        inner(debris.volume);
        inner(debris.density);
        inner(debris.ablation_energy);
    });
    io.list(world.tips, 64, [](auto& inner, auto& tip) {
        inner(tip.lens);
        inner(tip.capsule);
        inner(tip.iris);
        inner(tip.debris);
        inner(tip.open);
        inner(tip.suction);
        inner(tip.flow);
        inner(tip.hold);
    });
    io.list(world.plungers, 24, [](auto& inner, auto& plunger) {
        inner(plunger.pushed);
        inner(plunger.force);
        inner(plunger.stiffness);
    });
}

void sheet_fields(auto& io, auto& sheet) {
    io(sheet.mesh.nodes);
    io.list(sheet.mesh.triangles, 12, [](auto& inner, auto& triangle) {
        for (auto& node : triangle) {
            inner(node);
        }
    });
    io(sheet.origin);
    io(sheet.fibre);
    io(sheet.thickness);
    io(sheet.stiffness);
}

void shared_sheet(Writing& io, const std::shared_ptr<const MembraneSheet>& sheet) { sheet_fields(io, *sheet); }

void shared_sheet(Reading& io, std::shared_ptr<const MembraneSheet>& sheet) {
    std::shared_ptr<MembraneSheet> read = std::make_shared<MembraneSheet>();
    sheet_fields(io, *read);
    const bool sound = io.reader.ok() && validate_tri_mesh(read->mesh, {}, UnusedNodes::allowed).ok();
    io.limit(sound);
    if (sound) {
        read->neighbours = tri_neighbours(read->mesh);
    }
    sheet = std::move(read);
}

void membrane_fields(auto& io, auto& membrane) {
    shared_sheet(io, membrane.sheet);
    io(membrane.position);
    io(membrane.velocity);
    io.list(membrane.tips, 52, [](auto& inner, auto& tip) {
        inner(tip.node);
        inner(tip.direction);
        inner(tip.owed);
    });
    io.list(membrane.loads, 32, [](auto& inner, auto& load) {
        inner(load.nodes);
        inner(load.total);
    });
    io.list(membrane.touches, 40, [](auto& inner, auto& touch) {
        inner(touch.triangle);
        inner(touch.node);
        inner(touch.partner);
        inner.limit(touch.partner >= ContactPartner::tool && touch.partner <= ContactPartner::support);
        inner(touch.index);
        inner(touch.stretch);
    });
    io.list(membrane.grips, 41, [](auto& inner, auto& grip) {
        inner(grip.tool);
        inner(grip.node);
        inner(grip.place);
        inner(grip.pushed);
        inner(grip.slack);
    });
    io.list(membrane.punctures, 24, [](auto& inner, auto& place) { inner(place); });
    io(membrane.support.lift);
    io(membrane.support.push);
    io(membrane.torn_area);
    io(membrane.torn_energy);
    io(membrane.edge_out);
    io(membrane.area_out);
}

void shell_fields(auto& io, auto& shell) {
    io(shell.position);
    io(shell.rotation);
    io(shell.velocity);
    io(shell.spin);
    io(shell.branch);
    io.list(shell.loads, 32, [](auto& inner, auto& load) {
        inner(load.nodes);
        inner(load.total);
    });
    io.list(shell.touches, 37, [](auto& inner, auto& touch) {
        inner(touch.partner);
        inner.limit(touch.partner >= ContactPartner::tool && touch.partner <= ContactPartner::jaws);
        inner(touch.index);
        inner(touch.sample);
        inner(touch.front);
        inner(touch.stretch);
    });
    io(shell.loaded);
}

void world_fields(auto& io, auto& world) {
    io.list(world.solids, 48, [](auto& inner, auto& solid) {
        inner(solid.position);
        inner(solid.velocity);
        inner(solid.fraction);
        inner.list(solid.spent, 36, [](auto& spent_io, auto& spent) {
            spent_io(spent.fine);
            for (auto& left : spent.left) {
                spent_io(left);
            }
        });
        inner(solid.present);
        inner.list(solid.broken, 8, [](auto& face_io, auto& face) {
            face_io(face[0]);
            face_io(face[1]);
        });
        inner.list(solid.splits, 12, [](auto& split_io, auto& split) {
            split_io(split.node);
            split_io(split.tets);
        });
    });
    io.list(world.membranes, 104, [](auto& inner, auto& membrane) { membrane_fields(inner, membrane); });
    io.list(world.shells, 57, [](auto& inner, auto& shell) { shell_fields(inner, shell); });
    io.list(world.bags, 169, [](auto& inner, auto& bag) {
        inner(bag.pose);
        inner(bag.velocity);
        inner(bag.angular_velocity);
        inner(bag.cushion_z);
        inner(bag.load);
        inner(bag.adherent);
        inner.maybe(bag.zonules, [](auto& zonule_io, auto& zonules) {
            zonule_io(zonules.broken);
            zonule_io.list(zonules.hooks, 56, [](auto& hook_io, auto& hook) {
                hook_io(hook.on_bag);
                hook_io(hook.at_limbus);
                hook_io(hook.length);
            });
            zonule_io(zonules.ring);
        });
    });
    fluid_fields(io, world);
    wounds_fields(io, world);
    io.list(world.loads, 36, [](auto& inner, auto& load) {
        inner(load.solid);
        inner(load.nodes);
        inner(load.total);
    });
    io.list(world.memory, 64, [](auto& inner, auto& memory) {
        inner(memory.solid);
        inner(memory.vertex);
        inner(memory.partner);
        inner(memory.partner_index);
        inner(memory.anchor);
        inner(memory.force);
    });
    io(world.removed_mass);
    io(world.ablation_energy);
    io(world.time_s);
}

void snapshot_fields(auto& io, auto& snapshot) {
    world_fields(io, snapshot.world);
    io.list(snapshot.tools, 227, [](auto& inner, auto& tool) {
        inner(tool.present);
        inner(tool.pose);
        inner(tool.previous_pose);
        inner(tool.velocity);
        inner(tool.angular_velocity);
        inner(tool.jaw);
        inner(tool.previous_jaw);
        inner(tool.pedal);
        inner(tool.irrigation);
        inner(tool.aspiration);
        inner(tool.power);
        inner(tool.ultrasound_s);
        inner(tool.bottle_height);
        inner(tool.pump_flow);
        inner(tool.vacuum_limit);
    });
    io(snapshot.settings);
    io(snapshot.observer_memory);
    io(snapshot.step);
}

void start_fields(auto& io, auto& start) {
    observation_fields(io, start.observation);
    io(start.hash);
}

template <typename T, typename Fields>
std::string encoded(const T& value, const Fields& fields) {
    Writing io;
    fields(io, value);
    return io.writer.bytes();
}

template <typename T, typename Fields>
std::optional<T> decoded(std::string_view bytes, const Fields& fields) {
    Reading io(bytes);
    T value;
    fields(io, value);
    return io.good() ? std::optional<T>(std::move(value)) : std::nullopt;
}

constexpr auto header_io = [](auto& io, auto& value) { header_fields(io, value); };
constexpr auto start_io = [](auto& io, auto& value) { start_fields(io, value); };
constexpr auto step_io = [](auto& io, auto& value) { step_fields(io, value); };
constexpr auto snapshot_io = [](auto& io, auto& value) { snapshot_fields(io, value); };

}  // namespace

std::string encode(const RecordingHeader& header) { return encoded(header, header_io); }
std::string encode(const RecordedStart& start) { return encoded(start, start_io); }
std::string encode(const RecordedStep& step) { return encoded(step, step_io); }
std::string encode(const Snapshot& snapshot) { return encoded(snapshot, snapshot_io); }

std::optional<RecordingHeader> decode_header(std::string_view bytes) {
    return decoded<RecordingHeader>(bytes, header_io);
}
std::optional<RecordedStart> decode_start(std::string_view bytes) { return decoded<RecordedStart>(bytes, start_io); }
std::optional<RecordedStep> decode_step(std::string_view bytes) { return decoded<RecordedStep>(bytes, step_io); }
std::optional<Snapshot> decode_snapshot(std::string_view bytes) { return decoded<Snapshot>(bytes, snapshot_io); }

}  // namespace rhexis
