/**
 * @file callbacks.hpp
 * @brief Functions and adapters in C++ that the library calls. Part of vblast_ss.hpp, which includes it.
 *
 * The library is C, so no exception may pass through it. #vbss::callback and #vbss::adapter catch what
 * their functions throw.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_CALLBACKS_HPP
#define VBLAST_SS_CALLBACKS_HPP

#include <vblast_ss/vblast_ss.h>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <type_traits>
#include <utility>

namespace vbss
{

template <class S> class callback;

/** A function of the host that the library calls, such as `vbss::callback<void(vbss_log_level, const char *)>`
 * for #vbss_log_fn. Set the C callback to `call` and its user pointer to the address of this object, which
 * must outlive the object that calls it. `call` returns a fixed value when the function throws. */
template <class R, class... A> class callback<R(A...)>
{
  public:
    /** Wraps a function.
     * @param function  the function of the host
     * @param failed    value that call returns when it throws
     */
    template <class F, class V = int>
    explicit callback(F function, V failed = V()) : function_(std::move(function)), failed_(failed)
    {
    }
    callback(const callback &) = delete;
    callback &operator=(const callback &) = delete;
    /** The function for C. It never throws.
     * @param user       address of the callback object
     * @param arguments  arguments of the library
     * @return the result of the function, or the value for a failure
     */
    static R call(void *user, A... arguments) noexcept
    {
        callback *self = static_cast<callback *>(user);
        try {
            return self->function_(arguments...);
        } catch (...) {
            if (!self->caught_) {
                self->caught_ = std::current_exception();
            }
        }
        if constexpr (!std::is_void_v<R>) {
            return self->failed_;
        }
    }
    /** Throws the first exception of the function since the last call of rethrow; none: does nothing. */
    void rethrow()
    {
        if (caught_) {
            std::rethrow_exception(std::exchange(caught_, nullptr));
        }
    }

  private:
    std::function<R(A...)> function_;
    std::conditional_t<std::is_void_v<R>, int, R> failed_;
    std::exception_ptr caught_;
};

/** An adapter of the host's hardware: a class that overrides `read` and `write` at least, and what else
 * the hardware has. #vbss::adapter::table makes the table for #vbss_device_create. A function that throws
 * returns VBSS_ERROR_DEVICE to the library; the text of the exception is in #vbss_device_get_error. A
 * read that throws also reports the device as lost. The adapter must outlive its device, and stays at its
 * address. Its functions run in the thread that calls the device, and must not wait. */
class adapter
{
  public:
    adapter() = default;
    adapter(const adapter &) = delete;
    adapter &operator=(const adapter &) = delete;
    virtual ~adapter() = default;
    /** Returns the table of functions for #vbss_device_create.
     * @param name  name of the device in messages; copied when the device is created
     * @return the table
     */
    vbss_device_adapter table(const char *name = "device") noexcept
    {
        vbss_device_adapter filled = vbss_device_adapter_default();
        filled.name = name;
        filled.user = this;
        filled.open = [](void *user) { return guard(user, [](adapter &a) { a.open(); }); };
        filled.close = [](void *user) { static_cast<adapter *>(user)->close(); };
        filled.describe = [](void *user, vbss_device_capabilities *out) {
            return guard(user, [out](adapter &a) { a.describe(*out); });
        };
        filled.read = [](void *user, double now, vbss_device_sample *sample) {
            const vbss_result result =
                guard(user, [now, sample](adapter &a) { a.read(now, *sample); });
            if (result != VBSS_OK) {
                sample->flags |= VBSS_DEVICE_FLAG_LOST;
            }
            return result;
        };
        filled.write = [](void *user, double now, const vbss_output_result *output) {
            return guard(user, [now, output](adapter &a) { a.write(now, *output); });
        };
        filled.explain = [](void *user, char *text, std::uint32_t bytes) {
            (void)std::snprintf(text, bytes, "%s", static_cast<adapter *>(user)->text_);
        };
        return filled;
    }

  protected:
    /** Opens the hardware; may wait. */
    virtual void open()
    {
    }
    /** Closes the hardware. The library has switched its outputs off before. */
    virtual void close() noexcept
    {
    }
    /** Fills in the capabilities. Without an override: every signal and every output, no limits.
     * @param[out] capabilities  cleared
     */
    virtual void describe(vbss_device_capabilities &capabilities)
    {
        capabilities.signals = 2u * VBSS_DEVICE_HAS_TEMPERATURE - 1u;
        capabilities.outputs =
            VBSS_DEVICE_OUT_FORCE | VBSS_DEVICE_OUT_TORQUE | VBSS_DEVICE_OUT_SOLENOID;
    }
    /** Returns the newest sample, with the bits of its valid parts and its time.
     * @param now          the host's clock, s
     * @param[out] sample  cleared, with orientation (1, 0, 0, 0)
     */
    virtual void read(double now, vbss_device_sample &sample) = 0;
    /** Writes the outputs.
     * @param now     the host's clock, s
     * @param output  the outputs, within the limits of the output stage
     */
    virtual void write(double now, const vbss_output_result &output) = 0;

  private:
    template <class F> static vbss_result guard(void *user, F function) noexcept
    {
        adapter *self = static_cast<adapter *>(user);
        try {
            function(*self);
            return VBSS_OK;
        } catch (const std::exception &error) {
            (void)std::snprintf(self->text_, sizeof self->text_, "%s", error.what());
        } catch (...) {
            (void)std::snprintf(self->text_, sizeof self->text_, "unknown exception");
        }
        return VBSS_ERROR_DEVICE;
    }

    char text_[256] = "";
};

} // namespace vbss

#endif
