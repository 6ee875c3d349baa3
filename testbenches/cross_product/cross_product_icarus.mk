# cross_product: cross product: six exact products, three differences, one rounding each
# make -f cross_product_icarus.mk           runs the testbench
# make -f cross_product_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: cross_product_tb.vvp
	vvp -n $<
wave: cross_product_tb.vvp
	vvp -n $< +vcd
cross_product_tb.vvp: $(HDL)/cross_product.v cross_product_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f cross_product_tb.vvp cross_product_tb.vcd
