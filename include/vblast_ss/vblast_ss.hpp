/**
 * @file vblast_ss.hpp
 * @brief Owners, exceptions and views for C++17 and later. Header-only.
 *
 * The functions of the C headers remain the interface and the only ABI: everything here is inline. An
 * #vbss::owner converts to the pointer that these functions take. #vbss::owner::call calls one of them
 * and throws #vbss::error in place of a status. No exception may leave a callback, because the library
 * is C: #vbss::callback catches it, and its function rethrow throws it again after the call.
 *
 * The rules for threads are those of the C functions.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_VBLAST_SS_HPP
#define VBLAST_SS_VBLAST_SS_HPP

#include <vblast_ss/vblast_ss.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#if __cplusplus >= 202002L
#include <span>
#endif

namespace vbss
{

/** A status other than VBSS_OK. `what()` is the last error text of the context, or of the status. */
class error : public std::runtime_error
{
  public:
    /** An error.
     * @param result  the status
     * @param text    the text of what()
     */
    error(vbss_result result, const std::string &text) : std::runtime_error(text), result_(result)
    {
    }
    /** Returns the status.
     * @return the status, not VBSS_OK
     */
    vbss_result result() const noexcept
    {
        return result_;
    }

  private:
    vbss_result result_;
};

/** Throws #vbss::error unless a status is VBSS_OK.
 * @param result   the status
 * @param context  context that has the error text; nullptr: the text of the status
 */
inline void check(vbss_result result, const vbss_context *context = nullptr)
{
    if (result == VBSS_OK) {
        return;
    }
    vbss_result last = VBSS_OK;
    const char *text = nullptr;
    const bool is_known = context != nullptr &&
                          vbss_context_get_last_error(context, &last, &text) == VBSS_OK &&
                          last == result && text != nullptr;
    throw error(result, std::string(vbss_result_name(result)) + ": " +
                            (is_known ? text : vbss_result_string(result)));
}

#if defined(__cpp_lib_span)
/** Contiguous values: std::span where the library has it. */
template <class T> using span = std::span<T>;
#else
/** Contiguous values: the part of std::span that views need. */
template <class T> class span
{
  public:
    /** No values. */
    constexpr span() noexcept = default;
    /** Values one after the other.
     * @param data  the first value
     * @param size  number of values
     */
    constexpr span(T *data, std::size_t size) noexcept : data_(data), size_(size)
    {
    }
    /** Returns the first value.
     * @return pointer to the first value
     */
    constexpr T *data() const noexcept
    {
        return data_;
    }
    /** Returns the number of values.
     * @return the number
     */
    constexpr std::size_t size() const noexcept
    {
        return size_;
    }
    /** Returns whether there is no value.
     * @return true: there is none
     */
    constexpr bool empty() const noexcept
    {
        return size_ == 0;
    }
    /** Returns a value.
     * @param index  its index, below size()
     * @return the value
     */
    constexpr T &operator[](std::size_t index) const noexcept
    {
        return data_[index];
    }
    /** Returns the begin of the values.
     * @return pointer to the first value
     */
    constexpr T *begin() const noexcept
    {
        return data_;
    }
    /** Returns the end of the values.
     * @return pointer behind the last value
     */
    constexpr T *end() const noexcept
    {
        return data_ + size_;
    }

  private:
    T *data_ = nullptr;
    std::size_t size_ = 0;
};
#endif

/** Items of an array of the library, each a span of values of type T: double, std::uint32_t or float, as
 * #vbss_view_type says. Valid until the next step or edit of the object. */
template <class T> class items
{
  public:
    /** The items of a view. Throws #vbss::error (VBSS_ERROR_OUT_OF_RANGE) if its values are no T.
     * @param view  the view
     */
    explicit items(const vbss_view &view) : view_(view)
    {
        const bool is_type = view.type == VBSS_VIEW_TYPE_F64   ? std::is_same_v<T, double>
                             : view.type == VBSS_VIEW_TYPE_U32 ? std::is_same_v<T, std::uint32_t>
                                                               : std::is_same_v<T, float>;
        if (!is_type) {
            throw error(VBSS_ERROR_OUT_OF_RANGE, "the values of the view have another type");
        }
    }
    /** Returns the number of items.
     * @return the number
     */
    std::size_t size() const noexcept
    {
        return static_cast<std::size_t>(view_.count);
    }
    /** Returns an item.
     * @param index  its index, below size()
     * @return its values
     */
    span<const T> operator[](std::size_t index) const noexcept
    {
        const char *first = static_cast<const char *>(view_.data) + index * view_.stride_bytes;
        return span<const T>(reinterpret_cast<const T *>(first), view_.components);
    }
    /** Returns all values, one item after the other. Throws #vbss::error if there is space between items.
     * @return the values
     */
    span<const T> values() const
    {
        if (view_.stride_bytes != view_.components * sizeof(T) && view_.count > 1) {
            throw error(VBSS_ERROR_OUT_OF_RANGE, "the items of the view are not contiguous");
        }
        return span<const T>(static_cast<const T *>(view_.data), size() * view_.components);
    }
    /** Returns the view.
     * @return the view
     */
    const vbss_view &view() const noexcept
    {
        return view_;
    }

  private:
    vbss_view view_;
};

/** A context that its owner and all objects of it share: it is destroyed after the last of them. */
class context
{
  public:
    /** Creates a context. Throws #vbss::error.
     * @param config  configuration; nullptr: the defaults
     */
    explicit context(const vbss_context_config *config = nullptr)
    {
        vbss_context *created = nullptr;
        check(vbss_context_create(config, &created));
        shared_ = std::shared_ptr<vbss_context>(
            created, [](vbss_context *c) { (void)vbss_context_destroy(c); });
    }
    /** Returns the pointer for C functions.
     * @return the context
     */
    vbss_context *get() const noexcept
    {
        return shared_.get();
    }
    /** The pointer for C functions. */
    operator vbss_context *() const noexcept
    {
        return get();
    }

  private:
    std::shared_ptr<vbss_context> shared_;
};

/** The only owner of an object of type T. It can be moved and not copied. `destroy` is the function that
 * destroys the object. Owners may end in any order: a thread, drain, needle or grasper that still belongs
 * to a scene stays in it, and is destroyed when it leaves the scene. */
template <class T, vbss_result (*destroy)(T *)> class owner
{
  public:
    /** Owns nothing. */
    owner() noexcept = default;
    /** Owns an object.
     * @param context  its context
     * @param object   the object
     */
    owner(vbss::context context, T *object) noexcept : context_(std::move(context)), object_(object)
    {
    }
    /** Takes the object of another owner.
     * @param other  the other owner; it then owns nothing
     */
    owner(owner &&other) noexcept
        : context_(other.context_), object_(std::exchange(other.object_, nullptr))
    {
    }
    /** Destroys the object, and takes that of another owner.
     * @param other  the other owner; it then owns nothing
     * @return this owner
     */
    owner &operator=(owner &&other) noexcept
    {
        if (this != &other) {
            reset();
            context_ = other.context_;
            object_ = std::exchange(other.object_, nullptr);
        }
        return *this;
    }
    owner(const owner &) = delete;
    owner &operator=(const owner &) = delete;
    ~owner()
    {
        reset();
    }
    /** Destroys the object, if there is one. */
    void reset() noexcept
    {
        if (object_ != nullptr) {
            (void)destroy(std::exchange(object_, nullptr));
        }
    }
    /** Gives the object up: the caller destroys it.
     * @return the object; nullptr: none
     */
    T *release() noexcept
    {
        return std::exchange(object_, nullptr);
    }
    /** Returns the pointer for C functions.
     * @return the object; nullptr: none
     */
    T *get() const noexcept
    {
        return object_;
    }
    /** The pointer for C functions. */
    operator T *() const noexcept
    {
        return object_;
    }
    /** Returns the context. Only an owner that has had an object has one.
     * @return the context
     */
    const vbss::context &context() const noexcept
    {
        return *context_;
    }
    /** Throws #vbss::error unless a status is VBSS_OK, with the last error text of the context.
     * @param result  the status
     */
    void check(vbss_result result) const
    {
        vbss::check(result, context_.has_value() ? context_->get() : nullptr);
    }
    /** Calls a C function with the object and further arguments. Throws #vbss::error.
     * @param function   the C function
     * @param arguments  its arguments after the object
     */
    template <class... P, class... A>
    void call(vbss_result (*function)(T *, P...), A &&...arguments) const
    {
        check(function(object_, std::forward<A>(arguments)...));
    }
    /** Calls a C function that fills a struct S with its size behind it, such as
     * `scene.read<vbss_scene_statistics>(vbss_scene_get_statistics)`. Throws #vbss::error.
     * @param function   the C function
     * @param arguments  its arguments between the object and the struct
     * @return the struct
     */
    template <class S, class... P, class... A>
    S read(vbss_result (*function)(T *, P...), A &&...arguments) const
    {
        S filled;
        std::memset(&filled, 0, sizeof filled);
        check(function(object_, std::forward<A>(arguments)..., &filled,
                       static_cast<std::uint32_t>(sizeof filled)));
        return filled;
    }
    /** Returns the items of an array of the object, such as `thread.view<double>(vbss_thread_get_view,
     * VBSS_THREAD_VIEW_POSITIONS)`. Throws #vbss::error.
     * @param function  the C function that returns views
     * @param field     the array
     * @return its items
     */
    template <class V, class F> items<V> view(F function, std::int32_t field) const
    {
        return items<V>(read<vbss_view>(function, field));
    }

  private:
    std::optional<vbss::context> context_;
    T *object_ = nullptr;
};

/** Creates an object. Throws #vbss::error.
 * @param in         context of the object
 * @param create     C function that creates it
 * @param arguments  all its arguments before the result
 * @return the owner
 */
template <class Owner, class... P, class... A>
Owner make(const context &in, vbss_result (*create)(P...), A &&...arguments)
{
    std::remove_pointer_t<decltype(std::declval<Owner>().get())> *object = nullptr;
    check(create(std::forward<A>(arguments)..., &object), in);
    return Owner(in, object);
}

using collision =
    owner<vbss_collision, vbss_collision_destroy>;         /**< Owner of a collision object. */
using device = owner<vbss_device, vbss_device_destroy>;    /**< Owner of a device. */
using drain = owner<vbss_drain, vbss_drain_discard>;       /**< Owner of a drain. */
using grasper = owner<vbss_grasper, vbss_grasper_discard>; /**< Owner of a grasper. */
/** Owner of a knot detector. */
using knot_detector = owner<vbss_knot_detector, vbss_knot_detector_destroy>;
using metrics = owner<vbss_metrics, vbss_metrics_destroy>; /**< Owner of metrics. */
using mock = owner<vbss_mock, vbss_mock_destroy>;          /**< Owner of a mock device. */
using needle = owner<vbss_needle, vbss_needle_discard>;    /**< Owner of a needle. */
using nidaqmx = owner<vbss_nidaqmx, vbss_nidaqmx_destroy>; /**< Owner of an adapter. */
using openhaptics = owner<vbss_openhaptics, vbss_openhaptics_destroy>; /**< Owner of an adapter. */
using output = owner<vbss_output, vbss_output_destroy>;    /**< Owner of an output stage. */
using record = owner<vbss_record, vbss_record_destroy>;    /**< Owner of a record. */
using replay = owner<vbss_replay, vbss_replay_destroy>;    /**< Owner of a replay. */
using replica = owner<vbss_replica, vbss_replica_destroy>; /**< Owner of a replica. */
using scene = owner<vbss_scene, vbss_scene_destroy>;       /**< Owner of a scene. */
using session = owner<vbss_session, vbss_session_destroy>; /**< Owner of a session. */
using thread = owner<vbss_thread, vbss_thread_discard>;    /**< Owner of a thread. */
using visual = owner<vbss_visual, vbss_visual_destroy>;    /**< Owner of a visual. */

/** Creates a scene. Throws #vbss::error.
 * @param in      context of the scene
 * @param config  configuration; nullptr: the defaults
 * @return the owner
 */
inline scene make_scene(const context &in, const vbss_scene_config *config = nullptr)
{
    return make<scene>(in, vbss_scene_create, in.get(), config);
}

/** Creates a thread. Throws #vbss::error.
 * @param in      context of the thread
 * @param config  configuration; nullptr: the defaults
 * @return the owner
 */
inline thread make_thread(const context &in, const vbss_thread_config *config = nullptr)
{
    return make<thread>(in, vbss_thread_create, in.get(), config);
}

/** Takes all events out of the list of a scene, oldest first. Throws #vbss::error.
 * @param from       the scene
 * @param[out] lost  receives the number of events that were lost since the last call, because the list was
 *         full; nullptr: not wanted
 * @return the events
 */
inline std::vector<vbss_scene_event> take_events(const scene &from, std::uint64_t *lost = nullptr)
{
    std::uint32_t waiting = 0, taken = 0;
    const auto size = static_cast<std::uint32_t>(sizeof(vbss_scene_event));
    from.call(vbss_scene_take_events, nullptr, size, 0u, &waiting, nullptr);
    std::vector<vbss_scene_event> events(waiting +
                                         1u); /* room for one resets the count of lost events */
    from.call(vbss_scene_take_events, events.data(), size, waiting + 1u, &taken, lost);
    events.resize(taken);
    return events;
}

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

} // namespace vbss

#endif
