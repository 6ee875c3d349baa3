# rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
# make -f rsqrt_newton_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_rsqrt_newton/Vrsqrt_newton
	obj_rsqrt_newton/Vrsqrt_newton rsqrt_newton_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_rsqrt_newton/Vrsqrt_newton: $(HDL)/rsqrt_newton.v rsqrt_newton_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_rsqrt_newton -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_rsqrt_newton
