# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_printed_icarus.mk           runs the testbench
# make -f rotation_printed_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = rotation_printed_sincos.hex rotation_printed_asin.hex rotation_printed_recip_sin.hex rotation_printed_recip_cos.hex rotation_printed_atan.hex rotation_printed_prop.hex
.PHONY: run wave clean
run: rotation_printed_tb.vvp $(TABLES)
	vvp -n $<
wave: rotation_printed_tb.vvp $(TABLES)
	vvp -n $< +vcd
rotation_printed_tb.vvp: $(HDL)/rotation_printed.v rotation_printed_tb.v
	iverilog -g2005 -Wall -o $@ $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -f rotation_printed_tb.vvp rotation_printed_tb.vcd
