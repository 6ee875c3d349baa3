# sampler: texels and fractions of texture coordinates, nearest or bilinear, wrapped or clamped
# make -f sampler_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_sampler/Vsampler
	obj_sampler/Vsampler sampler_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_sampler/Vsampler: $(HDL)/sampler.v sampler_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_sampler -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_sampler
