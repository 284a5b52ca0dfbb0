# check_survival.R FOLDER: data.csv (set, law, lower, upper), fits.csv (set, law, location, dispersion, se_location,
# se_log_dispersion, log_likelihood) as written by the test program; modes.csv and mode_fits.csv likewise.
suppressMessages({library(survival); library(MASS); library(nnet)})
folder <- commandArgs(trailingOnly = TRUE)[1]
read <- function(name) read.csv(file.path(folder, name), stringsAsFactors = FALSE)
worst <- 0
compare <- function(what, ours, theirs, tolerance = 1e-6) {
    error <- max(abs(ours - theirs) / pmax(abs(theirs), 1e-3))
    worst <<- max(worst, error)
    if (!is.finite(error) || error > tolerance) {
        cat(what, ": ours", format(ours, digits = 12), "R", format(theirs, digits = 12), "\n")
        quit(status = 1)
    }
}

data <- read("data.csv")
fits <- read("fits.csv")
exact <- survreg.control(rel.tolerance = 1e-14, maxiter = 500)
for (i in seq_len(nrow(fits))) {
    f <- fits[i, ]
    d <- data[data$set == f$set, ]
    lower <- ifelse(is.infinite(d$lower) | d$lower <= 0, NA, d$lower)
    upper <- ifelse(is.infinite(d$upper), NA, d$upper)
    if (f$law == "gamma") { # no such law in survreg: maximised here, with R's own functions
        s <- ifelse(is.na(lower), 0, lower)
        term <- function(p) {
            shape <- exp(-2 * p[2]); scale <- exp(p[1] + 2 * p[2])
            below <- function(x) pgamma(x, shape, scale = scale)
            value <- -sum(ifelse(!is.na(upper) & s == upper, dgamma(s, shape, scale = scale, log = TRUE),
                 ifelse(is.na(upper), pgamma(s, shape, scale = scale, lower.tail = FALSE, log.p = TRUE),
                        log(pmax(below(ifelse(is.na(upper), 1, upper)) - below(s), 1e-300)))))
            if (is.finite(value)) value else 1e10
        }
        o <- optim(c(f$location, log(f$dispersion)) + c(0.05, -0.05), term, method = "Nelder-Mead",
                   control = list(reltol = 1e-15, maxit = 5000))
        o <- optim(o$par, term, method = "Nelder-Mead", control = list(reltol = 1e-16, maxit = 5000))
        compare(paste("set", f$set, "gamma log-likelihood"), f$log_likelihood, -o$value, 1e-9)
        compare(paste("set", f$set, "gamma"), c(f$location, f$dispersion), c(o$par[1], exp(o$par[2])), 1e-5)
        next
    }
    dist <- c(lognormal = "lognormal", normal = "gaussian", weibull = "weibull")[f$law]
    r <- survreg(Surv(lower, upper, type = "interval2") ~ 1, dist = dist, control = exact)
    where <- paste("set", f$set, f$law)
    compare(where, c(f$location, f$dispersion), c(coef(r), r$scale))
    compare(paste(where, "standard errors"), c(f$se_location, f$se_log_dispersion), sqrt(diag(vcov(r))))
    # of the log-likelihoods of interval-censored data survreg counts the jacobian of observed ones alone, as here
    compare(paste(where, "log-likelihood"), f$log_likelihood, r$loglik[1])
}

modes <- read("modes.csv")
mode_fits <- read("mode_fits.csv")
for (set in unique(modes$set)) {
    d <- modes[modes$set == set, ]
    ours <- mode_fits[mode_fits$set == set, ]
    r <- multinom(cbind(n0, n1, n2) ~ x, data = d, maxit = 10000, reltol = 1e-16, abstol = 1e-16, trace = FALSE)
    # its search stops early: finish with Newton steps on the same likelihood
    X <- cbind(1, d$x); C <- cbind(d$n0, d$n1, d$n2); N <- rowSums(C); b <- c(t(coef(r)))
    for (k in 1:20) {
        E <- cbind(0, X %*% b[1:2], X %*% b[3:4]); P <- exp(E) / rowSums(exp(E))
        g <- c(t(X) %*% (C[, 2] - N * P[, 2]), t(X) %*% (C[, 3] - N * P[, 3]))
        W <- function(i, j) t(X) %*% (N * P[, i] * ((i == j) - P[, j]) * X)
        H <- rbind(cbind(W(2, 2), W(2, 3)), cbind(W(3, 2), W(3, 3)))
        b <- b + solve(H, g)
    }
    compare(paste("modes", set), c(ours$a1, ours$b1, ours$a2, ours$b2), b)
    compare(paste("modes", set, "standard errors"), c(ours$se_a1, ours$se_b1, ours$se_a2, ours$se_b2),
            sqrt(diag(solve(H))))
}
cat(nrow(fits), "fits and", length(unique(modes$set)), "mode models agree with R; largest relative difference",
    format(worst, digits = 2), "\n")
