# dot: dot product of three: exact products and sums, one rounding
# make -f dot_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_dot/Vdot
	obj_dot/Vdot dot_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_dot/Vdot: $(HDL)/dot.v dot_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_dot -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_dot
