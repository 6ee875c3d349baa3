# rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
# make -f rsqrt_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_rsqrt/Vrsqrt
	obj_rsqrt/Vrsqrt rsqrt_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_rsqrt/Vrsqrt: $(HDL)/rsqrt.v rsqrt_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_rsqrt -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_rsqrt
