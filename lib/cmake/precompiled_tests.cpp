// Nothing: CMake compiles the headers that test programs share along with some source.
