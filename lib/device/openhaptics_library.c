/* Loads the OpenHaptics library and describes its errors. */
#include "base/error.h"
#include "device/openhaptics.h"

#ifdef _WIN32
static const char *const usual_names[] = {"hd.dll"};
#elif defined(__APPLE__)
static const char *const usual_names[] = {"libHD.dylib"};
#else
static const char *const usual_names[] = {"libHD.so", "libHD.so.3.4", "libHD.so.3.0"};
#endif
enum { USUAL_NAMES = sizeof usual_names / sizeof usual_names[0] };

vbss_result vbss_openhaptics_load(vbss_context *context, const char *name, hd_functions *hd)
{
    const device_symbol symbols[] = {
        {"hdInitDevice", &hd->init_device},
        {"hdDisableDevice", &hd->disable_device},
        {"hdMakeCurrentDevice", &hd->make_current_device},
        {"hdBeginFrame", &hd->begin_frame},
        {"hdEndFrame", &hd->end_frame},
        {"hdGetError", &hd->get_error},
        {"hdEnable", &hd->enable},
        {"hdDisable", &hd->disable},
        {"hdGetDoublev", &hd->get_doublev},
        {"hdGetIntegerv", &hd->get_integerv},
        {"hdSetDoublev", &hd->set_doublev},
        {"hdGetString", &hd->get_string},
        {"hdStartScheduler", &hd->start_scheduler},
        {"hdStopScheduler", &hd->stop_scheduler},
        {"hdSetSchedulerRate", &hd->set_scheduler_rate},
        {"hdScheduleAsynchronous", &hd->schedule},
        {"hdUnschedule", &hd->unschedule},
        {"hdWaitForCompletion", &hd->wait_for_completion},
        {"hdGetSchedulerTimeStamp", &hd->get_time_stamp},
        {"hdCheckCalibration", &hd->check_calibration},
        {"hdUpdateCalibration", &hd->update_calibration},
    };
    char text[DEVICE_LOAD_TEXT_BYTES] = "";
    const char *loaded = "";
    hd->library = name != NULL
                      ? vbss_device_load_any(&name, 1, &loaded, text, sizeof text)
                      : vbss_device_load_any(usual_names, USUAL_NAMES, &loaded, text, sizeof text);
    if (hd->library == NULL) {
        return vbss_fail(context, VBSS_ERROR_DEVICE, "OpenHaptics: %s", text);
    }
    const char *missing =
        vbss_device_find_symbols(hd->library, symbols, sizeof symbols / sizeof symbols[0]);
    if (missing != NULL) {
        return vbss_fail(context, VBSS_ERROR_DEVICE, "OpenHaptics: %s has no %s", loaded, missing);
    }
    return VBSS_OK;
}

const char *vbss_openhaptics_error_name(uint32_t code)
{
    static const struct {
        uint32_t code;
        const char *name;
    } names[] = {
        {0x0100, "no such parameter"},
        {0x0101, "a value it does not take"},
        {0x0102, "not allowed now"},
        {0x0103, "a parameter of another type"},
        {0x0104, "no such device"},
        {0x0200, "motors too warm"},
        {0x0201, "force above its largest"},
        {0x0202, "force rising too fast"},
        {0x0203, "arm moving too fast"},
        {0x0204, "force not put out"},
        {0x0300, "fault of the device"},
        {0x0301, "device opened already"},
        {0x0302, "communication failed"},
        {0x0303, "communication set up wrongly"},
        {0x0304, "timer failed"},
        {0x0400, "frame begun twice"},
        {0x0401, "frame ended without begin"},
        {0x0402, "more than one frame in a tick"},
        {0x0500, "no such priority"},
        {0x0501, "scheduler full"},
        {0x0600, "no valid licence"},
    };
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (names[i].code == code) {
            return names[i].name;
        }
    }
    return code == 0 ? "no error" : "an error without a name";
}

vbss_result vbss_openhaptics_check(vbss_context *context, const hd_functions *hd, const char *what)
{
    hd_error first = {0, 0, 0};
    for (int i = 0; i < 64; i++) { /* the newest error comes first */
        hd_error error = hd->get_error();
        if (error.code == 0) {
            break;
        }
        first = error;
    }
    return first.code == 0
               ? VBSS_OK
               : vbss_fail(context, VBSS_ERROR_DEVICE, "OpenHaptics: %s: %s (0x%04x, %d)", what,
                           vbss_openhaptics_error_name(first.code), first.code, first.internal);
}
