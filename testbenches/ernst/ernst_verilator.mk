# ernst: light of a bump-mapped pixel by matrix, normalisation and Cartesian dot products
# make -f ernst_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_ernst/Vernst
	obj_ernst/Vernst ernst_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_ernst/Vernst: $(HDL)/ernst.v ernst_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_ernst -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_ernst
