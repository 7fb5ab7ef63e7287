"""What Vulkan there is, asked of the loader itself: Filament needs one, in hardware or in software."""

from __future__ import annotations

import ctypes

LIBRARY = "libvulkan.so.1"
REMEDY = "apt-get install libvulkan1 mesa-vulkan-drivers"
_INSTANCE_CREATE_INFO = 1
_PROPERTIES_BYTES = 2048  # VkPhysicalDeviceProperties is smaller
_NAME = slice(20, 276)  # five numbers stand before it


class _InstanceCreateInfo(ctypes.Structure):
    _fields_ = (
        ("structure", ctypes.c_uint32),
        ("next", ctypes.c_void_p),
        ("flags", ctypes.c_uint32),
        ("application", ctypes.c_void_p),
        ("layer_count", ctypes.c_uint32),
        ("layers", ctypes.c_void_p),
        ("extension_count", ctypes.c_uint32),
        ("extensions", ctypes.c_void_p),
    )


def vulkan_devices() -> list[str]:
    """Return name and driver version of each device; empty where Vulkan or every driver of it is missing."""
    try:
        vulkan = ctypes.CDLL(LIBRARY)
    except OSError:
        return []
    instance, wanted = ctypes.c_void_p(), _InstanceCreateInfo(_INSTANCE_CREATE_INFO)
    if vulkan.vkCreateInstance(ctypes.byref(wanted), None, ctypes.byref(instance)) != 0:
        return []
    try:
        count = ctypes.c_uint32()
        vulkan.vkEnumeratePhysicalDevices(instance, ctypes.byref(count), None)
        devices = (ctypes.c_void_p * count.value)()
        vulkan.vkEnumeratePhysicalDevices(instance, ctypes.byref(count), devices)
        return [_describe(vulkan, device) for device in devices]
    finally:
        vulkan.vkDestroyInstance(instance, None)


def _describe(vulkan: ctypes.CDLL, device: int | None) -> str:
    properties = ctypes.create_string_buffer(_PROPERTIES_BYTES)
    vulkan.vkGetPhysicalDeviceProperties(ctypes.c_void_p(device), properties)
    version = ctypes.c_uint32.from_buffer(properties, 4).value
    name = properties.raw[_NAME].split(b"\0")[0].decode(errors="replace")
    return f"{name}, driver {version >> 22}.{version >> 12 & 0x3FF}.{version & 0xFFF}"
