// The linear light of an sRGB code, both 8 bits: round(255 linear).
//
// Combinational. Equals SrgbToLinear8 in model/arith/srgb.h.

module srgb_table (
  input  ffgpu_pkg::channel_t code_i,
  output ffgpu_pkg::channel_t linear_o
);

  // Code 0 lowest.
  localparam logic [2047:0] Table = {
    256'hfffd_faf8_f6f4_f2ef_edeb_e9e7_e5e2_e0de_dcda_d8d6_d4d2_d0ce_ccca_c8c6_c4c2_c0be,
    256'hbcba_b8b7_b5b3_b1af_adab_aaa8_a6a4_a3a1_9f9d_9c9a_9897_9593_9290_8e8d_8b8a_8886,
    256'h8583_8280_7f7d_7c7a_7977_7674_7372_706f_6d6c_6b69_6867_6564_6361_605f_5d5c_5b5a,
    256'h5857_5655_5452_5150_4f4e_4d4c_4a49_4847_4645_4443_4241_403f_3e3d_3c3b_3a39_3837,
    256'h3635_3433_3332_3130_2f2e_2d2d_2c2b_2a29_2928_2726_2525_2423_2322_2120_201f_1e1e,
    256'h1d1d_1c1b_1b1a_1919_1818_1717_1616_1514_1413_1312_1211_1111_1010_0f0f_0e0e_0d0d,
    256'h0d0c_0c0c_0b0b_0a0a_0a09_0909_0808_0808_0707_0706_0606_0605_0505_0504_0404_0404,
    256'h0303_0303_0303_0202_0202_0202_0202_0101_0101_0101_0101_0101_0100_0000_0000_0000
  };

  assign linear_o = Table[{code_i, 3'd0} +: 8];

endmodule
