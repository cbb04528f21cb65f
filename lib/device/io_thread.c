/* A thread for hardware whose calls block, with its clock. */
#include "device/platform.h"

#ifdef _WIN32

#include <windows.h>

#ifndef CREATE_WAITABLE_TIMER_HIGH_RESOLUTION /* missing in older headers */
#define CREATE_WAITABLE_TIMER_HIGH_RESOLUTION 0x00000002
#endif

static DWORD WINAPI enter(void *user)
{
    const device_thread *thread = user;
    thread->run(thread->user);
    return 0;
}

bool vbss_device_start_thread(device_thread *thread)
{
    thread->handle = CreateThread(NULL, 0, enter, thread, 0, NULL);
    return thread->handle != NULL;
}

void vbss_device_join_thread(device_thread *thread)
{
    WaitForSingleObject(thread->handle, INFINITE);
    CloseHandle(thread->handle);
}

double vbss_device_time(void)
{
    LARGE_INTEGER frequency, count;
    QueryPerformanceFrequency(&frequency);
    QueryPerformanceCounter(&count);
    return (double)count.QuadPart / (double)frequency.QuadPart;
}

/* Sleep() has a resolution of 15.6 ms by default, which is too coarse for solenoids.
 * High-resolution timers exist from Windows 10 1803 on; without them the loop at the end polls the
 * clock. */
void vbss_device_sleep(double seconds)
{
    const double end = vbss_device_time() + seconds;
    const LARGE_INTEGER due = {.QuadPart = -(LONGLONG)(seconds * 1e7)}; /* relative, in 100 ns */
    HANDLE timer =
        CreateWaitableTimerExW(NULL, NULL, CREATE_WAITABLE_TIMER_HIGH_RESOLUTION, TIMER_ALL_ACCESS);
    if (timer != NULL) {
        if (SetWaitableTimer(timer, &due, 0, NULL, NULL, FALSE)) {
            WaitForSingleObject(timer, INFINITE);
        }
        CloseHandle(timer);
    }
    while (vbss_device_time() < end) {
        Sleep(0);
    }
}

#else

#include <time.h>

#ifdef __wasi__

bool vbss_device_start_thread(device_thread *thread)
{
    (void)thread;
    return false;
}

void vbss_device_join_thread(device_thread *thread)
{
    (void)thread;
}

#else

static void *enter(void *user)
{
    const device_thread *thread = user;
    thread->run(thread->user);
    return NULL;
}

bool vbss_device_start_thread(device_thread *thread)
{
    return pthread_create(&thread->handle, NULL, enter, thread) == 0;
}

void vbss_device_join_thread(device_thread *thread)
{
    pthread_join(thread->handle, NULL);
}

#endif

void vbss_device_sleep(double seconds)
{
    const time_t whole = (time_t)seconds;
    const struct timespec time = {whole, (long)((seconds - (double)whole) * 1e9)};
    nanosleep(&time, NULL);
}

double vbss_device_time(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

#endif
