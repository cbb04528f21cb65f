// The same from C++: statuses become exceptions, handles become owners, the C ABI stays in between.
#include <clocale>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include <vblast_ss/vblast_ss.h>

namespace
{

void check(vbss_result result)
{
    if (result != VBSS_OK) {
        throw std::runtime_error(std::string(vbss_result_name(result)) + ": " +
                                 vbss_result_string(result));
    }
}

struct ContextDeleter {
    void operator()(vbss_context *context) const
    {
        vbss_context_destroy(context);
    }
};
using Context = std::unique_ptr<vbss_context, ContextDeleter>;

Context make_context()
{
    vbss_context_config config;
    check(vbss_context_config_init(&config, sizeof config));
    vbss_context *context = nullptr;
    check(vbss_context_create(&config, &context));
    return Context(context);
}

} // namespace

int main()
{
    std::setlocale(LC_NUMERIC, "C"); // numbers with a decimal point
    try {
        const Context context = make_context();
        vbss_context_statistics statistics;
        check(vbss_context_get_statistics(context.get(), &statistics, sizeof statistics));
        std::printf("a context holds %llu bytes\n",
                    static_cast<unsigned long long>(statistics.bytes_allocated));

        vbss_context_config too_old;
        check(vbss_context_config_init(&too_old, 4)); // refused: smaller than the first version
    } catch (const std::runtime_error &error) {
        std::printf("caught %s\n", error.what());
        return 0;
    }
    return 1;
}
