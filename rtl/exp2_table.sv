// 64 chords of 2^-x over one octave: base_o = round(2^17 2^(-chord / 64)), slope_o what the next
// one has less.
//
// Combinational. Equals Exp2Table in model/arith/exp2.h.

module exp2_table (
  input  logic [5:0]  chord_i,
  output logic [17:0] base_o,
  output logic [11:0] slope_o
);

  always_comb begin
    unique case (chord_i)
      6'd0: {base_o, slope_o} = {18'd131072, 12'd1412};
      6'd1: {base_o, slope_o} = {18'd129660, 12'd1397};
      6'd2: {base_o, slope_o} = {18'd128263, 12'd1381};
      6'd3: {base_o, slope_o} = {18'd126882, 12'd1367};
      6'd4: {base_o, slope_o} = {18'd125515, 12'd1352};
      6'd5: {base_o, slope_o} = {18'd124163, 12'd1338};
      6'd6: {base_o, slope_o} = {18'd122825, 12'd1323};
      6'd7: {base_o, slope_o} = {18'd121502, 12'd1308};
      6'd8: {base_o, slope_o} = {18'd120194, 12'd1295};
      6'd9: {base_o, slope_o} = {18'd118899, 12'd1281};
      6'd10: {base_o, slope_o} = {18'd117618, 12'd1267};
      6'd11: {base_o, slope_o} = {18'd116351, 12'd1253};
      6'd12: {base_o, slope_o} = {18'd115098, 12'd1240};
      6'd13: {base_o, slope_o} = {18'd113858, 12'd1227};
      6'd14: {base_o, slope_o} = {18'd112631, 12'd1213};
      6'd15: {base_o, slope_o} = {18'd111418, 12'd1200};
      6'd16: {base_o, slope_o} = {18'd110218, 12'd1187};
      6'd17: {base_o, slope_o} = {18'd109031, 12'd1175};
      6'd18: {base_o, slope_o} = {18'd107856, 12'd1162};
      6'd19: {base_o, slope_o} = {18'd106694, 12'd1149};
      6'd20: {base_o, slope_o} = {18'd105545, 12'd1137};
      6'd21: {base_o, slope_o} = {18'd104408, 12'd1125};
      6'd22: {base_o, slope_o} = {18'd103283, 12'd1112};
      6'd23: {base_o, slope_o} = {18'd102171, 12'd1101};
      6'd24: {base_o, slope_o} = {18'd101070, 12'd1088};
      6'd25: {base_o, slope_o} = {18'd99982, 12'd1077};
      6'd26: {base_o, slope_o} = {18'd98905, 12'd1066};
      6'd27: {base_o, slope_o} = {18'd97839, 12'd1054};
      6'd28: {base_o, slope_o} = {18'd96785, 12'd1042};
      6'd29: {base_o, slope_o} = {18'd95743, 12'd1032};
      6'd30: {base_o, slope_o} = {18'd94711, 12'd1020};
      6'd31: {base_o, slope_o} = {18'd93691, 12'd1009};
      6'd32: {base_o, slope_o} = {18'd92682, 12'd998};
      6'd33: {base_o, slope_o} = {18'd91684, 12'd988};
      6'd34: {base_o, slope_o} = {18'd90696, 12'd977};
      6'd35: {base_o, slope_o} = {18'd89719, 12'd967};
      6'd36: {base_o, slope_o} = {18'd88752, 12'd956};
      6'd37: {base_o, slope_o} = {18'd87796, 12'd945};
      6'd38: {base_o, slope_o} = {18'd86851, 12'd936};
      6'd39: {base_o, slope_o} = {18'd85915, 12'd925};
      6'd40: {base_o, slope_o} = {18'd84990, 12'd916};
      6'd41: {base_o, slope_o} = {18'd84074, 12'd905};
      6'd42: {base_o, slope_o} = {18'd83169, 12'd896};
      6'd43: {base_o, slope_o} = {18'd82273, 12'd887};
      6'd44: {base_o, slope_o} = {18'd81386, 12'd876};
      6'd45: {base_o, slope_o} = {18'd80510, 12'd868};
      6'd46: {base_o, slope_o} = {18'd79642, 12'd857};
      6'd47: {base_o, slope_o} = {18'd78785, 12'd849};
      6'd48: {base_o, slope_o} = {18'd77936, 12'd840};
      6'd49: {base_o, slope_o} = {18'd77096, 12'd830};
      6'd50: {base_o, slope_o} = {18'd76266, 12'd822};
      6'd51: {base_o, slope_o} = {18'd75444, 12'd812};
      6'd52: {base_o, slope_o} = {18'd74632, 12'd804};
      6'd53: {base_o, slope_o} = {18'd73828, 12'd796};
      6'd54: {base_o, slope_o} = {18'd73032, 12'd786};
      6'd55: {base_o, slope_o} = {18'd72246, 12'd778};
      6'd56: {base_o, slope_o} = {18'd71468, 12'd770};
      6'd57: {base_o, slope_o} = {18'd70698, 12'd762};
      6'd58: {base_o, slope_o} = {18'd69936, 12'd753};
      6'd59: {base_o, slope_o} = {18'd69183, 12'd745};
      6'd60: {base_o, slope_o} = {18'd68438, 12'd738};
      6'd61: {base_o, slope_o} = {18'd67700, 12'd729};
      6'd62: {base_o, slope_o} = {18'd66971, 12'd721};
      6'd63: {base_o, slope_o} = {18'd66250, 12'd714};
    endcase
  end

endmodule
