# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_exact_polar_cordic_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_rotation_exact_polar_cordic/Vrotation_exact_polar_cordic
	obj_rotation_exact_polar_cordic/Vrotation_exact_polar_cordic rotation_exact_polar_cordic_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_rotation_exact_polar_cordic/Vrotation_exact_polar_cordic: $(HDL)/rotation_exact_polar_cordic.v rotation_exact_polar_cordic_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_rotation_exact_polar_cordic -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_rotation_exact_polar_cordic
