# Doxygen would put the name of the level into the names of what is in it; a block of language linkage has no name.
s|^inline namespace ISOSTRETCH_ISA {|extern "C++" {|
