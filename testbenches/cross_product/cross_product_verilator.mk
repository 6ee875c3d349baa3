# cross_product: cross product: six exact products, three differences, one rounding each
# make -f cross_product_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_cross_product/Vcross_product
	obj_cross_product/Vcross_product cross_product_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_cross_product/Vcross_product: $(HDL)/cross_product.v cross_product_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_cross_product -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_cross_product
