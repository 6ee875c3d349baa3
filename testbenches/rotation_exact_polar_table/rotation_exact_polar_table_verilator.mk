# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_exact_polar_table_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_rotation_exact_polar_table/Vrotation_exact_polar_table
	obj_rotation_exact_polar_table/Vrotation_exact_polar_table rotation_exact_polar_table_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_rotation_exact_polar_table/Vrotation_exact_polar_table: $(HDL)/rotation_exact_polar_table.v rotation_exact_polar_table_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_rotation_exact_polar_table -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_rotation_exact_polar_table
