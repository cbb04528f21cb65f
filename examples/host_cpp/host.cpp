// The same bridge as in examples/host_c, from a device layer in C++: interfaces instead of functions, exceptions instead of
// numbers. No exception may leave a function of the table: each is caught there, kept, and told as a status with a text.
#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include <vblast_ss/vblast_ss.h>

// ---- the host's device layer

namespace host
{

struct Vector {
    double x, y, z;
};

struct Reading {
    Vector millimetres;
    double lever; // 0 let go to 1 pressed
    double seconds;
};

class Haptic
{
  public:
    virtual ~Haptic() = default;
    virtual void start() = 0;
    virtual void stop() noexcept = 0;
    virtual double strongest() const = 0; // N
    virtual Reading read() = 0;           // throws if it is gone
    virtual void push(const Vector &newton) = 0;
};

// A pen that a hand moves slowly into a wall at x = 10 mm.
class Pen : public Haptic
{
  public:
    void start() override
    {
        running = true;
    }
    void stop() noexcept override
    {
        running = false;
        force = Vector();
    }
    double strongest() const override
    {
        return 2.0;
    }
    Reading read() override
    {
        check();
        return Reading{{15.0 * seconds, 0.0, 0.0}, 0.8, seconds};
    }
    void push(const Vector &newton) override
    {
        force = Vector();
        check();
        force = newton;
    }

    double seconds = 0.0;
    bool plugged = true, running = false;
    Vector force = Vector();

  private:
    void check() const
    {
        if (!plugged) {
            throw std::runtime_error("the pen is not there");
        }
    }
};

} // namespace host

// ---- the bridge

namespace
{

class Bridge
{
  public:
    explicit Bridge(host::Haptic &haptic) : haptic_(haptic)
    {
    }

    vbss_device_adapter table()
    {
        vbss_device_adapter table;
        if (vbss_device_adapter_init(&table, sizeof table) != VBSS_OK) {
            throw std::logic_error("header and library do not fit");
        }
        table.name = "pen";
        table.user = this;
        table.open = [](void *user) { return guard(user, [](Bridge &b) { b.haptic_.start(); }); };
        table.close = [](void *user) { static_cast<Bridge *>(user)->haptic_.stop(); };
        table.describe = [](void *user, vbss_device_capabilities *out) {
            return guard(user, [out](Bridge &b) { b.describe(*out); });
        };
        table.read = [](void *user, double, vbss_device_sample *sample) {
            sample->flags = VBSS_DEVICE_FLAG_LOST; // unless it can be read
            return guard(user, [sample](Bridge &b) { b.read(*sample); });
        };
        table.write = [](void *user, double, const vbss_output_result *output) {
            return guard(user, [output](Bridge &b) {
                b.haptic_.push(host::Vector{output->force[0], output->force[1], output->force[2]});
            });
        };
        table.explain = [](void *user, char *text, uint32_t bytes) {
            std::snprintf(text, bytes, "%s", static_cast<Bridge *>(user)->why_);
        };
        return table;
    }

  private:
    template <class F> static vbss_result guard(void *user, F f) noexcept
    {
        auto *bridge = static_cast<Bridge *>(user);
        try {
            f(*bridge);
            return VBSS_OK;
        } catch (const std::exception &error) {
            std::snprintf(bridge->why_, sizeof bridge->why_, "%s", error.what());
        } catch (...) {
            std::snprintf(bridge->why_, sizeof bridge->why_, "not told");
        }
        return VBSS_ERROR_DEVICE;
    }

    void describe(vbss_device_capabilities &out) const
    {
        out.signals = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_JAW;
        out.outputs = VBSS_DEVICE_OUT_FORCE;
        out.input_dof = out.output_dof = 3;
        out.max_force = haptic_.strongest();
        out.update_rate = 1000.0;
    }

    void read(vbss_device_sample &sample) const
    {
        const host::Reading now = haptic_.read();
        sample.position[0] = 1e-3 * now.millimetres.x;
        sample.position[1] = 1e-3 * now.millimetres.y;
        sample.position[2] = 1e-3 * now.millimetres.z;
        sample.jaw = 1.0 - now.lever;
        sample.time = now.seconds;
        sample.valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_JAW;
        sample.flags = 0;
    }

    host::Haptic &haptic_;
    char why_[128] = "";
};

// ---- the host's side: statuses become exceptions, handles become owners

void check(vbss_result result)
{
    if (result != VBSS_OK) {
        throw std::runtime_error(vbss_result_name(result));
    }
}

struct Destroy {
    void operator()(vbss_context *context) const
    {
        vbss_context_destroy(context);
    }
    void operator()(vbss_device *device) const
    {
        vbss_device_destroy(device);
    }
};

constexpr double wall = 10e-3;      // m
constexpr double stiffness = 300.0; // N/m

vbss_device_input turn(vbss_device *device, double now)
{
    vbss_device_input in;
    vbss_output_command command;
    vbss_device_coupling tool;
    check(vbss_device_read(device, now, &in, sizeof in));
    check(vbss_output_command_init(&command, sizeof command));
    check(vbss_device_coupling_init(&tool, sizeof tool));
    std::copy(in.position, in.position + 3, tool.position);
    tool.position[0] = std::min(in.position[0], wall); // the tool stays before the wall
    tool.stiffness = stiffness;
    check(vbss_device_write_coupled(device, now, &command, &tool, nullptr, 0));
    return in;
}

void expect(bool fact, const char *what)
{
    if (!fact) {
        throw std::runtime_error(what);
    }
}

void run()
{
    host::Pen pen;
    Bridge bridge(pen);
    vbss_context *made = nullptr;
    check(vbss_context_create(nullptr, &made));
    const std::unique_ptr<vbss_context, Destroy> context(made);
    const vbss_device_adapter table = bridge.table();
    vbss_device *opened = nullptr;
    check(vbss_device_create(context.get(), &table, nullptr, nullptr, &opened));
    std::unique_ptr<vbss_device, Destroy> device(opened);
    vbss_device_input in = vbss_device_input();
    for (int i = 1; i <= 1000; i++) {
        pen.seconds = 1e-3 * i;
        in = turn(device.get(), pen.seconds);
    }
    std::printf("pen at %.2f mm, opening %.2f, pushed back with %.3f N\n", 1e3 * in.position[0],
                in.jaw, -pen.force.x);
    expect(std::fabs(pen.force.x + stiffness * (in.position[0] - wall)) < 1e-9,
           "not what the wall gives");
    pen.plugged = false;
    in = turn(device.get(), pen.seconds + 1e-3);
    const char *text = nullptr;
    check(vbss_device_get_error(device.get(), 0, nullptr, &text));
    std::printf("unplugged: %s, emergency stop %s\n", text,
                in.stopped != 0 ? "latched" : "not latched");
    expect(in.stopped != 0 && pen.force.x == 0.0, "it is not safe");
    device.reset();
    expect(!pen.running, "it was left open");
}

} // namespace

int main()
{
    std::setlocale(LC_NUMERIC, "C"); // numbers with a decimal point
    try {
        run();
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
