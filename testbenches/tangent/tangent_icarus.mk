# tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
# make -f tangent_icarus.mk           runs the testbench
# make -f tangent_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: tangent_tb.vvp
	vvp -n $<
wave: tangent_tb.vvp
	vvp -n $< +vcd
tangent_tb.vvp: $(HDL)/tangent.v tangent_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f tangent_tb.vvp tangent_tb.vcd
