# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_corrected_shared_icarus.mk           runs the testbench
# make -f rotation_corrected_shared_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = rotation_corrected_shared_sincos.hex rotation_corrected_shared_asin.hex rotation_corrected_shared_recip_sin.hex rotation_corrected_shared_recip_cos.hex rotation_corrected_shared_atan.hex rotation_corrected_shared_prop.hex
.PHONY: run wave clean
run: rotation_corrected_shared_tb.vvp $(TABLES)
	vvp -n $<
wave: rotation_corrected_shared_tb.vvp $(TABLES)
	vvp -n $< +vcd
rotation_corrected_shared_tb.vvp: $(HDL)/rotation_corrected_shared.v rotation_corrected_shared_tb.v
	iverilog -g2005 -Wall -o $@ $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -f rotation_corrected_shared_tb.vvp rotation_corrected_shared_tb.vcd
