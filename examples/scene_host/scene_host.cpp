// A host of a whole scene in C++17: two hands at 1 kHz with forces, meshes at 60 Hz in another thread, events, a cut, a
// snapshot and a log. scene_host.c does the same in C. Exit code 1: a restored or replayed state differs.
#include <vblast_ss/vblast_ss.hpp>

#include <algorithm>
#include <chrono>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <future>
#include <thread>

using namespace std::chrono_literals;
using steady = std::chrono::steady_clock;
constexpr int steps = 1000;             // of 1 ms
constexpr double half = 0.707106781186; // of the square root of 2

const auto print_message = [](vbss_log_level, const char *text) { std::puts(text); };

// Stands in for a haptic arm: it moves along a path, and keeps the largest force.
struct hand : vbss::adapter {
    double z = 0.0, largest_force = 0.0;
    void read(double now, vbss_device_sample &sample) override
    {
        const double down[4] = {half, -half, 0.0, 0.0};
        sample.position[0] = 0.01 * std::sin(2.0 * now);
        sample.position[1] = 0.02 + 0.01 * (1.0 - std::cos(2.0 * now));
        sample.position[2] = z;
        std::copy_n(down, 4, sample.orientation);
        sample.jaw = now > 0.4 && now < 0.6 ? 1.0 : 0.0;
        sample.valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_JAW;
        sample.time = now;
    }
    void write(double, const vbss_output_result &output) override
    {
        const double *f = output.force;
        largest_force = std::max(largest_force, std::hypot(f[0], f[1], f[2]));
    }
};

struct simulation {
    vbss::context context{print_message};
    hand hands[2];
    vbss::device devices[2];
    vbss::scene scene;
    vbss::drain drain;
    vbss::needle needle;
    vbss::thread thread;
    vbss::grasper tools[2];
    vbss::replica replica;
    vbss::record record;
    std::uint32_t thread_body = 0;
    std::vector<std::uint8_t> log, snapshot;
    std::uint64_t snapshot_hash = 0;
    int late = 0;

    simulation()
    {
        vbss_solver_options solver = vbss_solver_options_default();
        vbss_scene_config config = vbss_scene_config_default();
        solver.operations_per_us = vbss::measure_core_speed(context);
        config.solver = &solver;
        config.floor = 1;
        scene = context.make(vbss_scene_create, &config);
        vbss_drain_config tube = vbss_drain_config_default();
        tube.position[1] = tube.radius + tube.thickness / 2; // on the floor
        tube.position[2] = -0.06;
        drain = context.make(vbss_drain_create, &tube);
        scene.value(vbss_scene_add_drain, drain);
        add_suture();
        for (int i = 0; i < 2; i++) {
            hands[i].z = 0.02 + 0.04 * i;
            const vbss_device_adapter table = hands[i].table("hand");
            devices[i] = context.make(vbss_device_create, &table, nullptr, nullptr);
            tools[i] = context.make(vbss_grasper_create, nullptr);
            move_tool(i, 0.0);
            scene.value(vbss_scene_add_grasper, tools[i]);
        }
        scene.call(vbss_scene_prepare);
        replica = scene.make(vbss_replica_create, nullptr);
        record = scene.make(vbss_record_create, nullptr);
        scene.call(vbss_scene_set_recorder, record);
    }
    void add_suture() // a thread swaged to a needle
    {
        vbss_needle_config curved = vbss_needle_config_default();
        curved.position[0] = curved.radius;
        curved.position[1] = 0.03;
        curved.gravity[1] = -9.81;
        curved.orientation[0] = curved.orientation[1] = half;
        needle = context.make(vbss_needle_create, &curved);
        const auto pose = needle.read<vbss_needle_state>(vbss_needle_get_state);
        vbss_thread_config silk = vbss_thread_config_default();
        silk.cut_capacity = 1;
        std::copy_n(pose.swage, 3, silk.start);
        std::copy_n(pose.swage_direction, 3, silk.direction);
        thread = context.make(vbss_thread_create, &silk);
        thread_body = scene.value(vbss_scene_add_thread, thread);
        const std::uint32_t needle_body = scene.value(vbss_scene_add_needle, needle);
        scene.value(vbss_scene_pin_thread, thread_body, 0u, needle_body, nullptr);
    }
    void move_tool(int i, double now)
    {
        const auto input = devices[i].read<vbss_device_input>(vbss_device_read, now);
        tools[i].call(vbss_grasper_set_target, input.position, input.orientation);
        tools[i].call(vbss_grasper_set_opening, input.jaw);
    }
    void run_slot(double now)
    {
        move_tool(0, now);
        move_tool(1, now);
        scene.call(vbss_scene_step, 1e-3);
        for (int i = 0; i < 2; i++) {
            const auto tool = tools[i].read<vbss_grasper_state>(vbss_grasper_get_state);
            vbss_output_command command = vbss_output_command_default();
            std::copy_n(tool.hand_force, 3, command.force);
            devices[i].call(vbss_device_write, now, &command, nullptr, 0u);
        }
        replica.call(vbss_replica_publish, scene);
        for (const vbss_scene_event &event : vbss::take_events(scene)) {
            std::printf("%.3f s: event %d of body %u\n", event.time, event.kind, event.body_a);
        }
        take_log();
    }
    void take_log() // a host with a file writes the bytes instead
    {
        const auto bytes = vbss::take_bytes(record);
        log.insert(log.end(), bytes.begin(), bytes.end());
    }
    void run() // the haptic thread
    {
        const auto begin = steady::now();
        auto slot = begin;
        for (int step = 0; step < steps; step++) {
            std::this_thread::sleep_until(slot);
            run_slot(std::chrono::duration<double>(steady::now() - begin).count());
            late += steady::now() > slot + 1ms;
            slot = std::max(slot + 1ms, steady::now()); // a late thread does not catch up
            if (step == steps / 2) {
                scene.value(vbss_scene_cut_thread, thread_body, 0.04);
                snapshot = scene.save(vbss_scene_save);
                snapshot_hash = scene.value(vbss_scene_get_hash);
            }
        }
    }
};

// The renderer, in a context of its own, until the haptic thread ends.
static void draw(const simulation &s, const std::future<void> &haptic)
{
    const vbss::context context{print_message};
    const vbss::visual visual = context.make(vbss_visual_create, nullptr);
    visual.value(vbss_visual_add_replica, s.replica);
    auto frame = steady::now();
    while (haptic.wait_until(frame += 16667us) != std::future_status::ready) {
        if (vbss::take_state(s.replica).is_new != 0) {
            visual.call(vbss_visual_update);
            (void)visual.view<float>(vbss_visual_get_view, VBSS_VISUAL_VIEW_VERTICES); // upload
        }
    }
}

// Returns the hash of the scene at the end of a log.
static std::uint64_t replay(const std::vector<std::uint8_t> &log)
{
    const vbss::context context{print_message};
    const vbss::replay replay = context.make(vbss_replay_create, log.data(), log.size());
    const vbss::scene scene = replay.make(vbss_replay_load_scene);
    vbss::replay_to_end(replay);
    return scene.value(vbss_scene_get_hash);
}

static bool run()
{
    simulation s;
    std::future<void> haptic = std::async(std::launch::async, [&s] { s.run(); });
    draw(s, haptic);
    haptic.get(); // throws what the haptic thread has thrown
    const std::uint64_t hash = s.scene.value(vbss_scene_get_hash);
    s.record.call(vbss_record_end);
    s.take_log();
    s.scene.call(vbss_scene_restore, s.snapshot.data(), s.snapshot.size());
    const bool are_equal =
        s.scene.value(vbss_scene_get_hash) == s.snapshot_hash && replay(s.log) == hash;
    std::printf("%d of %d slots late, left hand up to %.3f N, hashes %s\n", s.late, steps,
                s.hands[0].largest_force, are_equal ? "equal" : "different");
    return are_equal;
}

int main()
{
    std::setlocale(LC_NUMERIC, "C"); // numbers with a decimal point
    try {
        return run() ? 0 : 1;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
