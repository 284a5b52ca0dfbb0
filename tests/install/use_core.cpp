
int main() { return core::normal_cdf(core::normal_quantile(0.25)) == 0.25 ? 0 : 1; }
