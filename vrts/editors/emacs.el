(define-derived-mode val2-mode prog-mode "VAL-II" (setq-local comment-start ";"))
(add-to-list 'auto-mode-alist '("\\.\\(v2\\|pg\\|lc\\)\\'" . val2-mode))
(with-eval-after-load 'eglot (add-to-list 'eglot-server-programs '(val2-mode "vrts" "lsp")))
