"""Conan 2 recipe. Copied to the top of an unpacked source archive: docs/reference/platforms.md."""
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, rmdir


class VblastSs(ConanFile):
    name = "vblast_ss"
    description = "Simulation of laparoscopic suturing with intracorporeal knot tying"
    license = "Apache-2.0"
    topics = ("simulation", "surgery", "haptics")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True}
    languages = "C"
    implements = ["auto_shared_fpic"]
    exports_sources = "CMakeLists.txt", "LICENSE", "include/*", "lib/*", "pkgconfig/*"

    def set_version(self):
        base = load(self, os.path.join(self.recipe_folder, "include", "vblast_ss", "base.h"))
        numbers = re.findall(r"^#define VBSS_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", base, re.M)
        self.version = ".".join(numbers) + re.search(r'^#define VBSS_VERSION_SUFFIX "(.*)"$', base, re.M).group(1)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["VBSS_BUILD_TESTS"] = False
        toolchain.cache_variables["VBSS_BUILD_EXAMPLES"] = False
        toolchain.cache_variables["VBSS_BUILD_SHARED"] = bool(self.options.shared)
        toolchain.cache_variables["VBSS_BUILD_STATIC"] = not self.options.shared
        toolchain.cache_variables["VBSS_REVISION"] = f"conan {self.version}"
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()
        # Conan writes its own files for CMake and pkg-config.
        rmdir(self, os.path.join(self.package_folder, "lib", "cmake"))
        rmdir(self, os.path.join(self.package_folder, "lib", "pkgconfig"))

    def package_info(self):
        self.cpp_info.libs = ["vblast_ss"]
        self.cpp_info.set_property("cmake_file_name", "vblast_ss")
        self.cpp_info.set_property("cmake_target_name", "vblast_ss::vblast_ss")
        self.cpp_info.set_property("pkg_config_name", "vblast_ss")
        if self.options.shared:
            self.cpp_info.defines = ["VBSS_USING_SHARED"]
        if self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.system_libs = ["m"]
