/* A gamepad that is not there, put before GLFW's own functions (LD_PRELOAD): its state is what stands in the file that
 * VBSS_STAND_IN_GAMEPAD names; while there is no such file, there is no gamepad. */
#include <stdio.h>
#include <stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

int glfwGetGamepadState(int number, GLFWgamepadstate *state)
{
    const char *path = getenv("VBSS_STAND_IN_GAMEPAD");
    FILE *file = path != NULL && number == GLFW_JOYSTICK_1 ? fopen(path, "rb") : NULL;
    if (file == NULL) {
        return GLFW_FALSE;
    }
    const int good = fread(state, sizeof *state, 1, file) == 1 ? GLFW_TRUE : GLFW_FALSE;
    (void)fclose(file);
    return good;
}
