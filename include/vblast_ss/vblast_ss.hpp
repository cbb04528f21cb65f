/**
 * @file vblast_ss.hpp
 * @brief Owners, exceptions and views for C++17 and later. Header-only.
 *
 * The functions of the C headers remain the interface and the only ABI: everything here is inline. An
 * #vbss::owner converts to the pointer that these functions take. Its members `make`, `call`, `value`,
 * `read`, `view` and `save` call one of them, and throw #vbss::error in place of a status. No exception
 * may leave a callback: callbacks.hpp catches them.
 *
 * The rules for threads are those of the C functions.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_VBLAST_SS_HPP
#define VBLAST_SS_VBLAST_SS_HPP

#include <vblast_ss/callbacks.hpp>
#include <vblast_ss/vblast_ss.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
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
    /** Returns a pointer to the first value.
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

/** @cond */
namespace detail
{
/* The functions that owners end an object with. */
inline vbss_result end(vbss_collision *object) noexcept
{
    return vbss_collision_destroy(object);
}
inline vbss_result end(vbss_device *object) noexcept
{
    return vbss_device_destroy(object);
}
inline vbss_result end(vbss_drain *object) noexcept
{
    return vbss_drain_discard(object);
}
inline vbss_result end(vbss_grasper *object) noexcept
{
    return vbss_grasper_discard(object);
}
inline vbss_result end(vbss_knot_detector *object) noexcept
{
    return vbss_knot_detector_destroy(object);
}
inline vbss_result end(vbss_metrics *object) noexcept
{
    return vbss_metrics_destroy(object);
}
inline vbss_result end(vbss_mock *object) noexcept
{
    return vbss_mock_destroy(object);
}
inline vbss_result end(vbss_needle *object) noexcept
{
    return vbss_needle_discard(object);
}
inline vbss_result end(vbss_nidaqmx *object) noexcept
{
    return vbss_nidaqmx_destroy(object);
}
inline vbss_result end(vbss_openhaptics *object) noexcept
{
    return vbss_openhaptics_destroy(object);
}
inline vbss_result end(vbss_output *object) noexcept
{
    return vbss_output_destroy(object);
}
inline vbss_result end(vbss_record *object) noexcept
{
    return vbss_record_destroy(object);
}
inline vbss_result end(vbss_replay *object) noexcept
{
    return vbss_replay_destroy(object);
}
inline vbss_result end(vbss_replica *object) noexcept
{
    return vbss_replica_destroy(object);
}
inline vbss_result end(vbss_scene *object) noexcept
{
    return vbss_scene_destroy(object);
}
inline vbss_result end(vbss_session *object) noexcept
{
    return vbss_session_destroy(object);
}
inline vbss_result end(vbss_thread *object) noexcept
{
    return vbss_thread_discard(object);
}
inline vbss_result end(vbss_visual *object) noexcept
{
    return vbss_visual_destroy(object);
}

/* The type that the last parameter of a C function points to. */
template <class... P>
using last = std::remove_pointer_t<std::tuple_element_t<sizeof...(P) - 1, std::tuple<P...>>>;
} // namespace detail
/** @endcond */

template <class T> class owner;

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
    /** Creates a context with the defaults that passes its messages to a function. The context keeps the
     * function. An exception of the function is dropped. Throws #vbss::error.
     * @param log    the function
     * @param level  least important level that it receives
     */
    explicit context(std::function<void(vbss_log_level, const char *)> log,
                     vbss_log_level level = VBSS_LOG_WARNING)
    {
        using logger = callback<void(vbss_log_level, const char *)>;
        const auto kept = std::make_shared<logger>(std::move(log));
        vbss_context_config config = vbss_context_config_default();
        config.log = kept->call;
        config.log_user = kept.get();
        config.log_level = level;
        vbss_context *created = nullptr;
        check(vbss_context_create(&config, &created));
        shared_ = std::shared_ptr<vbss_context>(
            created, [kept](vbss_context *c) { (void)vbss_context_destroy(c); });
    }
    /** Creates an object with a C function, such as `context.make(vbss_drain_create, &config)`. Throws
     * #vbss::error.
     * @param create     the C function
     * @param arguments  its arguments between the context and the new object
     * @return the owner
     */
    template <class... P, class... A>
    auto make(vbss_result (*create)(vbss_context *, P...), A &&...arguments) const;
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

/** The only owner of an object of type T. It can be moved and not copied. Owners may end in any order: a thread, drain, needle or grasper that still belongs
 * to a scene stays in it, and is destroyed when it leaves the scene. */
template <class T> class owner
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
            (void)detail::end(std::exchange(object_, nullptr));
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
    /** Calls a C function whose last parameter receives a value, such as
     * `scene.value(vbss_scene_get_hash)` or `scene.value(vbss_scene_add_thread, thread)`. Throws
     * #vbss::error.
     * @param function   the C function
     * @param arguments  its arguments between the object and the value
     * @return the value
     */
    template <class... P, class... A>
    detail::last<P...> value(vbss_result (*function)(T *, P...), A &&...arguments) const
    {
        detail::last<P...> filled{};
        check(function(object_, std::forward<A>(arguments)..., &filled));
        return filled;
    }
    /** Creates an object of the same context with a C function of this object, such as
     * `scene.make(vbss_replica_create, nullptr)`. Throws #vbss::error.
     * @param create     the C function
     * @param arguments  its arguments between this object and the new one
     * @return the owner
     */
    template <class... P, class... A>
    auto make(vbss_result (*create)(T *, P...), A &&...arguments) const
    {
        return owner<std::remove_pointer_t<detail::last<P...>>>(
            *context_, value(create, std::forward<A>(arguments)...));
    }
    /** Returns the state of the object, such as `scene.save(vbss_scene_save)`. Throws #vbss::error.
     * @param function  the C function that saves the object
     * @return the bytes for the C function that restores it
     */
    template <class B>
    std::vector<std::uint8_t> save(vbss_result (*function)(T *, B *, std::uint64_t,
                                                           std::uint64_t *)) const
    {
        std::uint64_t size = 0;
        (void)function(object_, nullptr, 0, &size); /* asks for the size */
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
        check(function(object_, bytes.data(), size, &size));
        return bytes;
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

template <class... P, class... A>
auto context::make(vbss_result (*create)(vbss_context *, P...), A &&...arguments) const
{
    detail::last<P...> object = nullptr;
    check(create(get(), std::forward<A>(arguments)..., &object), get());
    return owner<std::remove_pointer_t<detail::last<P...>>>(*this, object);
}

using collision = owner<vbss_collision>;         /**< Owner of a collision object. */
using device = owner<vbss_device>;               /**< Owner of a device. */
using drain = owner<vbss_drain>;                 /**< Owner of a drain. */
using grasper = owner<vbss_grasper>;             /**< Owner of a grasper. */
using knot_detector = owner<vbss_knot_detector>; /**< Owner of a knot detector. */
using metrics = owner<vbss_metrics>;             /**< Owner of metrics. */
using mock = owner<vbss_mock>;                   /**< Owner of a mock device. */
using needle = owner<vbss_needle>;               /**< Owner of a needle. */
using nidaqmx = owner<vbss_nidaqmx>;             /**< Owner of an adapter. */
using openhaptics = owner<vbss_openhaptics>;     /**< Owner of an adapter. */
using output = owner<vbss_output>;               /**< Owner of an output stage. */
using record = owner<vbss_record>;               /**< Owner of a record. */
using replay = owner<vbss_replay>;               /**< Owner of a replay. */
using replica = owner<vbss_replica>;             /**< Owner of a replica. */
using scene = owner<vbss_scene>;                 /**< Owner of a scene. */
using session = owner<vbss_session>;             /**< Owner of a session. */
using thread = owner<vbss_thread>;               /**< Owner of a thread. */
using visual = owner<vbss_visual>;               /**< Owner of a visual. */

/** Creates a scene. Throws #vbss::error.
 * @param in      context of the scene
 * @param config  configuration; nullptr: the defaults
 * @return the owner
 */
inline scene make_scene(const context &in, const vbss_scene_config *config = nullptr)
{
    return in.make(vbss_scene_create, config);
}

/** Creates a thread. Throws #vbss::error.
 * @param in      context of the thread
 * @param config  configuration; nullptr: the defaults
 * @return the owner
 */
inline thread make_thread(const context &in, const vbss_thread_config *config = nullptr)
{
    return in.make(vbss_thread_create, config);
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

/** Returns the bytes that were added to a log since the last call. Throws #vbss::error.
 * @param from  the record
 * @return the bytes, valid until the next call that records something
 */
inline span<const std::uint8_t> take_bytes(const record &from)
{
    const std::uint8_t *bytes = nullptr;
    std::uint64_t count = 0;
    from.call(vbss_record_take, &bytes, &count);
    return span<const std::uint8_t>(bytes, static_cast<std::size_t>(count));
}

/** Repeats the steps of a log to its end, or to its first difference. Throws #vbss::error, also if the log
 * is cut off or damaged.
 * @param from  a replay that has begun
 * @return the last report
 */
inline vbss_replay_report replay_to_end(const replay &from)
{
    vbss_replay_report report;
    do {
        report = from.read<vbss_replay_report>(vbss_replay_step);
    } while (report.outcome == VBSS_REPLAY_OUTCOME_STEPPED);
    return report;
}

/** Takes the newest state of a replica, in the reader's thread. Throws #vbss::error, without the error text
 * of the context, which belongs to the writer's thread.
 * @param from  the replica
 * @return the state
 */
inline vbss_replica_state take_state(const replica &from)
{
    vbss_replica_state state;
    check(vbss_replica_take(from, &state, static_cast<std::uint32_t>(sizeof state)));
    return state;
}

/** Measures the speed of the core with a steady clock (#vbss_core_speed_measure). Throws #vbss::error.
 * @param in  a context, which lends its memory
 * @return the speed for vbss_solver_options::operations_per_us, operations per us
 */
inline double measure_core_speed(const context &in)
{
    const auto seconds = [](void *) noexcept {
        const auto now = std::chrono::steady_clock::now().time_since_epoch();
        return std::chrono::duration<double>(now).count();
    };
    vbss_core_speed speed;
    check(vbss_core_speed_measure(in, seconds, nullptr, &speed,
                                  static_cast<std::uint32_t>(sizeof speed)),
          in);
    return speed.operations_per_us;
}

} // namespace vbss

#endif
