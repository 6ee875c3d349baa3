# tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
# make -f tangent_faceted_icarus.mk           runs the testbench
# make -f tangent_faceted_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: tangent_faceted_tb.vvp
	vvp -n $<
wave: tangent_faceted_tb.vvp
	vvp -n $< +vcd
tangent_faceted_tb.vvp: $(HDL)/tangent_faceted.v tangent_faceted_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f tangent_faceted_tb.vvp tangent_faceted_tb.vcd
