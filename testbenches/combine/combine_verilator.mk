# combine: diffuse light plus the differences of height samples: the emboss of one to eight lights
# make -f combine_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_combine/Vcombine
	obj_combine/Vcombine combine_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_combine/Vcombine: $(HDL)/combine.v combine_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_combine -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_combine
