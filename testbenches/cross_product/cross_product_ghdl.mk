# cross_product: cross product: six exact products, three differences, one rounding each
# make -f cross_product_ghdl.mk             runs the VHDL testbench
# make -f cross_product_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_cross_product
run: ghdl_cross_product/work-obj08.cf
	ghdl -r $(GHDL) cross_product_tb
wave: ghdl_cross_product/work-obj08.cf
	ghdl -r $(GHDL) cross_product_tb --vcd=cross_product_tb.vcd
ghdl_cross_product/work-obj08.cf: $(HDL)/cross_product.vhd cross_product_tb.vhd
	rm -rf ghdl_cross_product
	mkdir ghdl_cross_product
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_cross_product cross_product_tb.vcd
