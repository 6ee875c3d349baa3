# basis: binormal and tangent from normal and tangent: N x CT, normalised, x N
# make -f basis_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_basis/Vbasis
	obj_basis/Vbasis basis_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_basis/Vbasis: $(HDL)/basis.v basis_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_basis -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_basis
