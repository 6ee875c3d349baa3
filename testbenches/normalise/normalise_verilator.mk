# normalise: block normalisation: three words shifted by the leading zeros of the largest
# make -f normalise_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_normalise/Vnormalise
	obj_normalise/Vnormalise normalise_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_normalise/Vnormalise: $(HDL)/normalise.v normalise_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_normalise -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_normalise
